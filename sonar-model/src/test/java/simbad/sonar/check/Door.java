package simbad.sonar.check;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** A public constructor, or a public factory, and what it makes of NaN. */
record Door(Executable way) {
  private static final List<String> NUMBERS =
      List.of(
          "double",
          "float",
          "double[]",
          "double[][]",
          "double[][][]",
          "float[]",
          "java.util.List<java.lang.Double>",
          "java.util.OptionalDouble",
          "java.util.Optional<java.lang.Double>");

  /** All doors of a class that take numbers. */
  static Stream<Door> of(Class<?> type) {
    if (!isOpen(type)) {
      return Stream.empty();
    }
    Stream<Executable> constructors =
        Modifier.isAbstract(type.getModifiers())
            ? Stream.empty()
            : Arrays.stream(type.getConstructors());
    Stream<Executable> factories =
        Arrays.stream(type.getDeclaredMethods())
            .filter(method -> Modifier.isPublic(method.getModifiers()))
            .filter(method -> Modifier.isStatic(method.getModifiers()))
            .filter(method -> type.isAssignableFrom(method.getReturnType()))
            .map(method -> (Executable) method);
    return Stream.concat(constructors, factories)
        .map(Door::new)
        .filter(door -> door.numbers().length > 0);
  }

  /** True for what programs outside can name: a public class in none that is not. */
  private static boolean isOpen(@Nullable Class<?> type) {
    return type == null
        || (Modifier.isPublic(type.getModifiers()) && isOpen(type.getEnclosingClass()));
  }

  int[] numbers() {
    Type[] types = way.getGenericParameterTypes();
    return IntStream.range(0, types.length)
        .filter(i -> NUMBERS.contains(types[i].getTypeName()))
        .toArray();
  }

  /** Arguments that it takes; empty where none are found. */
  Optional<Object[]> sample(Samples samples) {
    for (Samples.Pattern pattern : Samples.Pattern.values()) {
      Type[] types = way.getGenericParameterTypes();
      Object[] arguments = new Object[types.length];
      for (int i = 0; i < types.length; i++) {
        arguments[i] = samples.of(types[i], pattern, i);
      }
      if (complaint(arguments).isEmpty()) {
        return Optional.of(arguments);
      }
    }
    return Optional.empty();
  }

  /** The places at which it takes NaN, or refuses it without saying so. */
  List<String> faults(Object[] sample) {
    List<String> faults = new ArrayList<>();
    for (int i : numbers()) {
      Object[] arguments = sample.clone();
      arguments[i] = notANumber(arguments[i]);
      if (arguments[i] == null) {
        continue;
      }
      Optional<Throwable> complaint = complaint(arguments);
      if (complaint.isEmpty()) {
        faults.add(this + " takes NaN as argument " + (i + 1));
      } else if (!(complaint.get() instanceof IllegalArgumentException)
          || !String.valueOf(complaint.get().getMessage()).contains("NaN")) {
        faults.add(this + " says of NaN as argument " + (i + 1) + ": " + complaint.get());
      }
    }
    return faults;
  }

  private static Object notANumber(Object sample) {
    if (sample instanceof double[][] || sample instanceof double[][][]) {
      Object[] changed = ((Object[]) sample).clone();
      changed[changed.length / 2] = notANumber(changed[changed.length / 2]);
      return changed;
    }
    if (sample instanceof float[] values) {
      float[] changed = values.clone();
      changed[changed.length / 2] = Float.NaN;
      return changed;
    }
    if (sample instanceof double[] values) {
      double[] changed = values.clone();
      changed[changed.length / 2] = Double.NaN;
      return changed;
    }
    if (sample instanceof List<?> values) {
      List<Object> changed = new ArrayList<>(values);
      changed.set(changed.size() / 2, Double.NaN);
      return changed;
    }
    if (sample instanceof OptionalDouble) {
      return OptionalDouble.of(Double.NaN);
    }
    if (sample instanceof Optional<?>) {
      return Optional.of(Double.NaN);
    }
    return sample instanceof Float ? (Object) Float.NaN : (Object) Double.NaN;
  }

  private Optional<Throwable> complaint(Object... arguments) {
    try {
      if (way instanceof Constructor<?> constructor) {
        constructor.newInstance(arguments);
      } else {
        ((Method) way).invoke(null, arguments);
      }
      return Optional.empty();
    } catch (InvocationTargetException fault) {
      return Optional.of(fault.getTargetException());
    } catch (ReflectiveOperationException | IllegalArgumentException fault) {
      return Optional.of(new IllegalStateException("no sample for " + this, fault));
    }
  }

  @Override
  public String toString() {
    String types =
        String.join(
            ", ", Arrays.stream(way.getParameterTypes()).map(Class::getSimpleName).toList());
    String name = way.getDeclaringClass().getName().replace("simbad.", "").replace("sonar.", "");
    return name + (way instanceof Method ? "." + way.getName() : "") + "(" + types + ")";
  }
}
