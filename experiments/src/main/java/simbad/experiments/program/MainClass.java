package simbad.experiments.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * What of a program can be started.
 *
 * @param mains classes with a main
 * @param environments classes that are environments and have a constructor without arguments
 */
public record MainClass(List<String> mains, List<String> environments) {
  private static final String ENVIRONMENT = "simbad/sim/EnvironmentDescription";

  /** Finds what can be started, in the order of the names. */
  public static MainClass of(ProgramClasses classes) {
    Map<String, String> parents = new TreeMap<>();
    List<String> mains = new ArrayList<>();
    List<String> made = new ArrayList<>();
    for (byte[] bytes : classes.bytes().values()) {
      ClassReader reader = new ClassReader(bytes);
      parents.put(reader.getClassName(), String.valueOf(reader.getSuperName()));
      Finder finder = new Finder();
      reader.accept(finder, ClassReader.SKIP_CODE);
      if (finder.hasMain) {
        mains.add(reader.getClassName().replace('/', '.'));
      }
      if (finder.hasConstructor) {
        made.add(reader.getClassName());
      }
    }
    List<String> environments =
        made.stream()
            .filter(type -> isEnvironment(type, parents))
            .map(type -> type.replace('/', '.'))
            .toList();
    return new MainClass(List.copyOf(mains), environments);
  }

  private static boolean isEnvironment(String type, Map<String, String> parents) {
    String parent = type;
    while (parents.containsKey(parent)) {
      parent = parents.get(parent);
    }
    return parent.equals(ENVIRONMENT);
  }

  private static final class Finder extends ClassVisitor {
    private boolean hasMain;
    private boolean hasConstructor;
    private boolean isAbstract;

    Finder() {
      super(Opcodes.ASM9);
    }

    @Override
    public void visit(
        int version, int access, String name, String signature, String parent, String[] faces) {
      isAbstract = (access & Opcodes.ACC_ABSTRACT) != 0;
    }

    @Override
    public @Nullable MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      boolean isStatic = (access & Opcodes.ACC_STATIC) != 0;
      boolean isPublic = (access & Opcodes.ACC_PUBLIC) != 0;
      hasMain |=
          isStatic
              && isPublic
              && name.equals("main")
              && descriptor.equals("([Ljava/lang/String;)V");
      hasConstructor |= !isAbstract && name.equals("<init>") && descriptor.equals("()V");
      return null;
    }
  }
}
