package simbad.api;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A line of the list: a class with what it is or has. */
record Signature(String owner, String what) {
  private static final Pattern AT_VERB = Pattern.compile(" (?=is |has )");

  static Signature parse(String line) {
    String[] parts = AT_VERB.split(line, 2);
    return new Signature(parts[0], parts[1]);
  }

  /** Looks the line up among what the class has, its own or inherited. */
  boolean exists() {
    Pattern pattern = Pattern.compile(Pattern.quote(what).replace("?", "\\E[^ ,()]+\\Q"));
    return findClass().map(Signature::describe).orElse(List.of()).stream()
        .anyMatch(line -> pattern.matcher(line).matches());
  }

  private Optional<Class<?>> findClass() {
    String name = owner;
    for (int dot = name.length(); dot > 0; dot = name.lastIndexOf('.', dot - 1)) {
      String candidate = owner.substring(0, dot) + owner.substring(dot).replace('.', '$');
      try {
        return Optional.of(Class.forName(candidate, false, Signature.class.getClassLoader()));
      } catch (ClassNotFoundException e) {
        // The name may stand for a nested class.
      }
    }
    return Optional.empty();
  }

  /** Lists a class in the words of the file. */
  static List<String> describe(Class<?> type) {
    List<String> lines = new ArrayList<>();
    lines.add("is " + describeType(type));
    Arrays.stream(type.getDeclaredConstructors()).map(Signature::line).forEach(lines::add);
    for (Class<?> c = type; c != null && c.getName().startsWith("simbad."); c = c.getSuperclass()) {
      Arrays.stream(c.getDeclaredMethods()).map(Signature::line).forEach(lines::add);
      Arrays.stream(c.getDeclaredFields()).map(Signature::line).forEach(lines::add);
    }
    return lines;
  }

  private static String describeType(Class<?> type) {
    int modifiers = type.getModifiers() & (Modifier.PUBLIC | Modifier.ABSTRACT);
    Class<?> parent = type.getSuperclass();
    String text = Modifier.toString(modifiers) + " class";
    if (parent != Object.class) {
      text += " extends " + parent.getSimpleName();
    }
    if (type.getInterfaces().length > 0) {
      text += " implements " + names(type.getInterfaces());
    }
    return text;
  }

  private static String line(Constructor<?> constructor) {
    return "has "
        + Modifier.toString(constructor.getModifiers())
        + " ("
        + names(constructor.getParameterTypes())
        + ")";
  }

  private static String line(Method method) {
    int modifiers = method.getModifiers() & Modifier.methodModifiers() & ~Modifier.SYNCHRONIZED;
    return words(modifiers, method.getReturnType())
        + method.getName()
        + "("
        + names(method.getParameterTypes())
        + ")";
  }

  private static String line(Field field) {
    String text = words(field.getModifiers(), field.getType()) + field.getName();
    return isConstant(field) ? text + " = " + value(field) : text;
  }

  private static boolean isConstant(Field field) {
    int modifiers = field.getModifiers();
    return Modifier.isStatic(modifiers)
        && Modifier.isFinal(modifiers)
        && !Modifier.isPrivate(modifiers)
        && field.getType().isPrimitive();
  }

  private static String value(Field field) {
    try {
      field.setAccessible(true);
      Object value = field.get(null);
      return value instanceof Float ? value + "f" : String.valueOf(value);
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String words(int modifiers, Type type) {
    String words = "has " + Modifier.toString(modifiers);
    return words.strip() + " " + ((Class<?>) type).getSimpleName() + " ";
  }

  private static String names(Class<?>[] types) {
    return Stream.of(types).map(Class::getSimpleName).collect(Collectors.joining(", "));
  }

  @Override
  public String toString() {
    return owner + " " + what;
  }
}
