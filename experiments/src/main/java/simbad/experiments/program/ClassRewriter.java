package simbad.experiments.program;

import java.util.Arrays;
import java.util.Map;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.SimpleRemapper;

/**
 * Sends the calls of a program's classes to what stands in for the main window, for chance, for the
 * clock and for the end of the process. Nothing else of a class changes.
 */
final class ClassRewriter {
  static final String FRAME = "simbad/gui/Simbad";
  private static final String STAND_INS = Type.getInternalName(StandIns.class);
  private static final String CHANCE = Type.getInternalName(StandIns.Chance.class);
  private static final String RANDOM = "java/util/Random";

  /** Static methods that have stand-ins of the same name. */
  private static final Map<String, String> STATIC =
      Map.of(
          "java/lang/Math.random()D", "random",
          "java/lang/StrictMath.random()D", "random",
          "java/lang/System.exit(I)V", "exit",
          "java/lang/Thread.sleep(J)V", "sleep");

  private ClassRewriter() {}

  /**
   * Rewrites a class.
   *
   * @param bytes of the class file
   * @param headless whether the main window is stood in for, too
   */
  static byte[] rewrite(byte[] bytes, boolean headless) {
    ClassReader reader = new ClassReader(bytes);
    ClassWriter writer = new ClassWriter(0);
    ClassVisitor visitor = writer;
    if (headless) {
      String frame = Type.getInternalName(HeadlessFrame.class);
      visitor = new ClassRemapper(visitor, new SimpleRemapper(Opcodes.ASM9, Map.of(FRAME, frame)));
    }
    reader.accept(new Calls(visitor, headless), 0);
    return writer.toByteArray();
  }

  private static final class Calls extends ClassVisitor {
    private final boolean headless;

    Calls(ClassVisitor next, boolean headless) {
      super(Opcodes.ASM9, next);
      this.headless = headless;
    }

    @Override
    public void visit(
        int version, int access, String name, String signature, String parent, String[] faces) {
      super.visit(version, access, name, signature, parent.equals(RANDOM) ? CHANCE : parent, faces);
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      MethodVisitor next = super.visitMethod(access, name, descriptor, signature, exceptions);
      return new Code(next, headless);
    }
  }

  private static final class Code extends MethodVisitor {
    private final boolean headless;

    Code(MethodVisitor next, boolean headless) {
      super(Opcodes.ASM9, next);
      this.headless = headless;
    }

    /** A {@code new Random()} becomes one of the run. */
    @Override
    public void visitTypeInsn(int opcode, String type) {
      boolean random = opcode == Opcodes.NEW && type.equals(RANDOM);
      super.visitTypeInsn(opcode, random ? CHANCE : type);
    }

    @Override
    public void visitMethodInsn(
        int opcode, String owner, String name, String descriptor, boolean isInterface) {
      if (opcode == Opcodes.INVOKESTATIC && STATIC.containsKey(owner + "." + name + descriptor)) {
        super.visitMethodInsn(opcode, STAND_INS, name, descriptor, false);
      } else if (opcode == Opcodes.INVOKESPECIAL && owner.equals(RANDOM) && name.equals("<init>")) {
        super.visitMethodInsn(opcode, CHANCE, name, descriptor, false);
      } else if (headless
          && opcode == Opcodes.INVOKEVIRTUAL
          && isOfWindow(owner, name, descriptor)) {
        leaveOut(descriptor);
      } else {
        super.visitMethodInsn(opcode, owner, name, descriptor, isInterface);
      }
    }

    /** True for what the main window inherits from Swing. */
    private static boolean isOfWindow(String owner, String name, String descriptor) {
      return owner.equals(FRAME)
          && Arrays.stream(HeadlessFrame.class.getMethods())
              .noneMatch(
                  method ->
                      method.getName().equals(name)
                          && Type.getMethodDescriptor(method)
                              .replace(Type.getInternalName(HeadlessFrame.class), FRAME)
                              .equals(descriptor));
    }

    /** Takes the arguments and the window off the stack and answers 0, false or null. */
    private void leaveOut(String descriptor) {
      Type[] arguments = Type.getArgumentTypes(descriptor);
      for (int i = arguments.length - 1; i >= 0; i--) {
        super.visitInsn(arguments[i].getSize() == 2 ? Opcodes.POP2 : Opcodes.POP);
      }
      super.visitInsn(Opcodes.POP);
      switch (Type.getReturnType(descriptor).getSort()) {
        case Type.VOID -> {}
        case Type.LONG -> super.visitInsn(Opcodes.LCONST_0);
        case Type.DOUBLE -> super.visitInsn(Opcodes.DCONST_0);
        case Type.FLOAT -> super.visitInsn(Opcodes.FCONST_0);
        case Type.OBJECT, Type.ARRAY -> super.visitInsn(Opcodes.ACONST_NULL);
        default -> super.visitInsn(Opcodes.ICONST_0);
      }
    }
  }
}
