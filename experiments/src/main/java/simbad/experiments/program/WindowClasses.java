package simbad.experiments.program;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.commons.Remapper;
import org.objectweb.asm.commons.SimpleRemapper;

/**
 * Which classes of a program are windows, and what of a window its stand-in has not. A program may
 * extend the main window or open windows of its own.
 */
final class WindowClasses {
  private static final Map<String, Class<?>> STAND_INS =
      Map.of("simbad/gui/Simbad", HeadlessFrame.class, "javax/swing/JFrame", HeadlessWindow.class);

  /** From windows to their stand-ins. */
  static final Remapper REMAPPER =
      new SimpleRemapper(
          Opcodes.ASM9,
          STAND_INS.entrySet().stream()
              .collect(
                  Collectors.toMap(
                      Map.Entry::getKey, entry -> Type.getInternalName(entry.getValue()))));

  private static final Map<String, Set<String>> METHODS =
      STAND_INS.entrySet().stream()
          .collect(Collectors.toMap(Map.Entry::getKey, entry -> methods(entry.getValue())));

  private final Function<String, Optional<byte[]>> bytes;
  private final Map<String, Facts> known = new HashMap<>();

  /**
   * Knows the classes of a program.
   *
   * @param bytes of the class file of a name such as {@code java.lang.String}, if it is one of the
   *     program's own or of its libraries
   */
  WindowClasses(Function<String, Optional<byte[]>> bytes) {
    this.bytes = bytes;
  }

  private static Set<String> methods(Class<?> standIn) {
    return Stream.<Class<?>>iterate(standIn, type -> type != null, Class::getSuperclass)
        .flatMap(type -> Arrays.stream(type.getDeclaredMethods()))
        .map(WindowClasses::key)
        .collect(Collectors.toSet());
  }

  private static String key(Method method) {
    return method.getName() + Type.getMethodDescriptor(method);
  }

  /** True for a method that a window inherits from Swing and that its stand-in has not. */
  boolean lacks(String owner, String method, String descriptor) {
    String type = owner;
    while (!STAND_INS.containsKey(type)) {
      Facts facts = known.computeIfAbsent(type, this::read);
      if (facts.parent.isEmpty() || facts.methods.contains(method + descriptor)) {
        return false;
      }
      type = facts.parent;
    }
    return !METHODS
        .getOrDefault(type, Set.of())
        .contains(method + REMAPPER.mapMethodDesc(descriptor));
  }

  private Facts read(String type) {
    Facts facts = new Facts();
    bytes
        .apply(type.replace('/', '.'))
        .ifPresent(file -> new ClassReader(file).accept(facts, ClassReader.SKIP_CODE));
    return facts;
  }

  /** What a class extends, nothing if it is none of the program's, and what it has of its own. */
  private static final class Facts extends ClassVisitor {
    private String parent = "";
    private final Set<String> methods = new HashSet<>();

    Facts() {
      super(Opcodes.ASM9);
    }

    @Override
    public void visit(
        int version,
        int access,
        String name,
        String signature,
        @Nullable String extended,
        String[] faces) {
      parent = extended == null ? "" : extended;
    }

    @Override
    public @Nullable MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      methods.add(name + descriptor);
      return null;
    }
  }
}
