package simbad.experiments.program;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** Finds what a program asks Simbad for that is not there: members of an edited copy, as a rule. */
final class MissingMembers {
  private static final String CONSTRUCTOR = "<init>";

  private final Map<String, String> parents = new TreeMap<>();
  private final Map<String, SortedSet<String>> members = new TreeMap<>();
  private final SortedSet<Place> missing =
      new TreeSet<>(
          Comparator.comparing(Place::file).thenComparing(Place::line).thenComparing(Place::what));

  private record Place(String file, int line, String what) {}

  private MissingMembers() {}

  /**
   * Returns a line for each place: file, line, and what is missing there; in the order of names.
   */
  static List<String> of(ProgramClasses classes) {
    MissingMembers found = new MissingMembers();
    classes.bytes().values().forEach(bytes -> found.visit(bytes, false));
    classes.bytes().values().forEach(bytes -> found.visit(bytes, true));
    return found.missing.stream()
        .map(place -> place.file() + ":" + place.line() + ": " + place.what())
        .toList();
  }

  private void visit(byte[] bytes, boolean look) {
    new ClassReader(bytes).accept(new Declarations(look), ClassReader.SKIP_FRAMES);
  }

  /** First learns what the program's own classes are and have, then looks up what they ask for. */
  private final class Declarations extends ClassVisitor {
    private final boolean look;
    private String name = "";
    private String file = "";

    Declarations(boolean look) {
      super(Opcodes.ASM9);
      this.look = look;
    }

    @Override
    public void visit(
        int version, int access, String type, String signature, String parent, String[] faces) {
      name = type;
      file = type;
      parents.put(type, parent == null ? "java/lang/Object" : parent);
    }

    @Override
    public void visitSource(String source, String debug) {
      file = source == null ? name : source;
    }

    @Override
    public @Nullable FieldVisitor visitField(
        int access, String field, String descriptor, String signature, Object value) {
      members.computeIfAbsent(name, key -> new TreeSet<>()).add(field);
      return null;
    }

    @Override
    public @Nullable MethodVisitor visitMethod(
        int access, String method, String descriptor, String signature, String[] exceptions) {
      members.computeIfAbsent(name, key -> new TreeSet<>()).add(method + descriptor);
      return look ? new Uses(file) : null;
    }
  }

  private final class Uses extends MethodVisitor {
    private final String file;
    private int line;

    Uses(String file) {
      super(Opcodes.ASM9);
      this.file = file;
    }

    @Override
    public void visitLineNumber(int number, Label start) {
      line = number;
    }

    @Override
    public void visitMethodInsn(
        int opcode, String owner, String method, String descriptor, boolean isInterface) {
      if (!exists(owner, method, descriptor)) {
        report(owner, method.equals(CONSTRUCTOR) ? "" : "." + method, arguments(descriptor));
      }
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String field, String descriptor) {
      if (!exists(owner, field, "")) {
        report(owner, "." + field, "");
      }
    }

    private void report(String owner, String member, String arguments) {
      missing.add(new Place(file, line, simbadParent(owner) + member + arguments));
    }
  }

  private static String arguments(String descriptor) {
    return Arrays.stream(Type.getArgumentTypes(descriptor))
        .map(Type::getClassName)
        .map(type -> type.substring(type.lastIndexOf('.') + 1))
        .toList()
        .toString()
        .replace('[', '(')
        .replace(']', ')');
  }

  private String simbadParent(String owner) {
    String type = owner;
    while (parents.containsKey(type) && !type.startsWith("simbad/")) {
      type = parents.get(type);
    }
    return type.replace('/', '.');
  }

  private boolean exists(String owner, String member, String descriptor) {
    String type = owner;
    while (parents.containsKey(type)) {
      if (members.getOrDefault(type, new TreeSet<>()).contains(member + descriptor)) {
        return true;
      }
      type = parents.get(type);
    }
    return !type.startsWith("simbad/") || existsHere(type, member, descriptor);
  }

  private static boolean existsHere(String type, String member, String descriptor) {
    try {
      ClassLoader loader = MissingMembers.class.getClassLoader();
      Class<?> owner = Class.forName(type.replace('/', '.'), false, loader);
      return member.equals(CONSTRUCTOR)
          ? Arrays.stream(owner.getDeclaredConstructors()).anyMatch(c -> fits(c, descriptor))
          : descriptor.isEmpty() ? hasField(owner, member) : hasMethod(owner, member, descriptor);
    } catch (ClassNotFoundException e) {
      return false;
    }
  }

  private static boolean fits(Constructor<?> constructor, String descriptor) {
    return Type.getConstructorDescriptor(constructor).equals(descriptor);
  }

  private static boolean hasMethod(Class<?> owner, String name, String descriptor) {
    for (Class<?> c = owner; c != null; c = c.getSuperclass()) {
      for (Method method : c.getDeclaredMethods()) {
        if (method.getName().equals(name) && Type.getMethodDescriptor(method).equals(descriptor)) {
          return true;
        }
      }
    }
    return Arrays.stream(owner.getMethods())
        .anyMatch(m -> m.getName().equals(name) && Type.getMethodDescriptor(m).equals(descriptor));
  }

  private static boolean hasField(Class<?> owner, String name) {
    for (Class<?> c = owner; c != null; c = c.getSuperclass()) {
      for (Field field : c.getDeclaredFields()) {
        if (field.getName().equals(name)) {
          return true;
        }
      }
    }
    return Arrays.stream(owner.getFields()).anyMatch(field -> field.getName().equals(name));
  }
}
