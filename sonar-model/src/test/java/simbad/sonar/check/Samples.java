package simbad.sonar.check;

import java.lang.reflect.Array;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Proxy;
import java.lang.reflect.Type;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;

/** Values that arguments of each type may have. */
public final class Samples {
  /** As many as the least table has. */
  private static final int MANY = 24;

  private final Map<Type, Object> known = new HashMap<>();

  /** Knows plain types only. */
  public Samples() {
    known.put(boolean.class, false);
    known.put(long.class, 1L);
    known.put(String.class, "post");
    known.put(Path.class, Path.of("file"));
    known.put(RandomGenerator.class, new SplittableRandom(1));
  }

  /** How the numbers of one call lie to each other. */
  enum Pattern {
    HALVES,
    RISING,
    ONES,
    NOUGHTS,
    FALLING;

    double at(int index) {
      return switch (this) {
        case HALVES -> 0.5;
        case RISING -> 0.1 * (index + 1);
        case ONES -> 1;
        case NOUGHTS -> 0;
        case FALLING -> 5 - 0.1 * index;
      };
    }
  }

  /** Adds a value of a type that cannot be made of nothing. */
  public Samples with(Type type, Object value) {
    known.put(type, value);
    return this;
  }

  /** A value of a type; null where none is known. */
  @Nullable Object of(Type type, Pattern pattern, int index) {
    if (known.containsKey(type)) {
      return known.get(type);
    }
    if (type == double.class) {
      return pattern.at(index);
    }
    if (type == float.class) {
      return (float) pattern.at(index);
    }
    if (type == int.class) {
      return pattern == Pattern.FALLING ? 0 : MANY;
    }
    if (type == float[].class) {
      float[] values = new float[MANY];
      Arrays.fill(values, (float) pattern.at(index));
      return values;
    }
    if (type == double[][].class || type == double[][][].class) {
      Class<?> inner = ((Class<?>) type).getComponentType();
      Object[] rows = (Object[]) Array.newInstance(inner, MANY);
      Arrays.setAll(rows, i -> of(inner, pattern, index));
      return rows;
    }
    if (type == double[].class) {
      double[] values = new double[MANY];
      Arrays.setAll(values, i -> pattern.at(pattern == Pattern.RISING ? i : index));
      return values;
    }
    if (type == OptionalDouble.class) {
      return OptionalDouble.empty();
    }
    if (type instanceof ParameterizedType generic) {
      return collection(generic, pattern, index);
    }
    return type instanceof Class<?> plain ? plain(plain) : null;
  }

  private @Nullable Object collection(ParameterizedType generic, Pattern pattern, int index) {
    Type element = generic.getActualTypeArguments()[0];
    if (generic.getRawType() == Optional.class) {
      return Optional.empty();
    }
    if (generic.getRawType() == Map.class) {
      return Map.of();
    }
    if (generic.getRawType() == Set.class) {
      return Set.of();
    }
    if (generic.getRawType() != List.class) {
      return known.get(generic.getRawType());
    }
    if (element == Double.class) {
      // Of an interval's bounds and what lies in it, the bounds come first.
      return List.of(pattern.at(pattern == Pattern.RISING ? index - 1 : index));
    }
    Object one = of(element, pattern, index);
    return one == null ? List.of() : List.of(one);
  }

  private static @Nullable Object plain(Class<?> type) {
    if (type.isEnum()) {
      return type.getEnumConstants()[0];
    }
    if (type.isInterface() && !type.isSealed()) {
      return Proxy.newProxyInstance(
          Samples.class.getClassLoader(), new Class<?>[] {type}, (proxy, method, values) -> 0.0);
    }
    return null;
  }
}
