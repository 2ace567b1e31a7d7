package simbad.experiments.program;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.SimpleRemapper;

/**
 * Sends the calls of a program's classes, and of its libraries', to what stands in for windows, for
 * chance, for the clock and for the end of the process. Nothing else of a class changes.
 */
final class ClassRewriter {
  private static final String STAND_INS = Type.getInternalName(StandIns.class);
  private static final String CHANCE = Type.getInternalName(StandIns.Chance.class);
  private static final String RANDOM = "java/util/Random";
  private static final String DIALOGS = "javax/swing/JOptionPane";
  private static final String CONSTRUCTOR = "<init>";

  /** Static methods that have stand-ins of the same name. */
  private static final Map<String, String> ALWAYS =
      Map.of(
          "java/lang/Math.random()D", "random",
          "java/lang/StrictMath.random()D", "random",
          "java/util/Collections.shuffle(Ljava/util/List;)V", "shuffle",
          "java/lang/System.exit(I)V", "exit");

  /** Those that have one without a window, where time and events go with the steps. */
  private static final Map<String, String> HEADLESS =
      Map.of(
          "java/lang/Thread.sleep(J)V", "sleep",
          "java/lang/System.currentTimeMillis()J", "currentTimeMillis",
          "java/lang/System.nanoTime()J", "nanoTime",
          "javax/swing/SwingUtilities.invokeLater(Ljava/lang/Runnable;)V", "invokeLater",
          "java/awt/EventQueue.invokeLater(Ljava/lang/Runnable;)V", "invokeLater",
          "javax/swing/SwingUtilities.invokeAndWait(Ljava/lang/Runnable;)V", "invokeAndWait",
          "java/awt/EventQueue.invokeAndWait(Ljava/lang/Runnable;)V", "invokeAndWait");

  /** Methods of objects, whose stand-ins are static and get the object first. */
  private static final Map<String, String> OF_OBJECTS =
      Map.of(
          "java/awt/Toolkit.getScreenSize()Ljava/awt/Dimension;", "getScreenSize",
          "simbad/sim/Simulator.startSimulation()V", "start",
          "simbad/sim/Simulator.startBackgroundMode()V", "start",
          "simbad/sim/Simulator.restartSimulation()V", "restart",
          "simbad/sim/Simulator.stopSimulation()V", "stop",
          "simbad/sim/Simulator.stopBackgroundMode()V", "stop");

  private final boolean headless;
  private final WindowClasses windows;

  /**
   * Rewrites for one run.
   *
   * @param bytes of the class file of a name, if it is one of the program's or of its libraries
   * @param headless whether windows and the clock are stood in for, too
   */
  ClassRewriter(Function<String, Optional<byte[]>> bytes, boolean headless) {
    this.headless = headless;
    windows = new WindowClasses(bytes);
  }

  /** Rewrites a class. */
  byte[] rewrite(byte[] bytes) {
    ClassReader reader = new ClassReader(bytes);
    ClassWriter writer = new ClassWriter(0);
    ClassVisitor visitor =
        new ClassRemapper(
            writer,
            new SimpleRemapper(
                Opcodes.ASM9, Map.of("java/util/concurrent/ThreadLocalRandom", CHANCE)));
    if (headless) {
      visitor = new ClassRemapper(visitor, WindowClasses.REMAPPER);
    }
    reader.accept(new Calls(visitor), 0);
    return writer.toByteArray();
  }

  private final class Calls extends ClassVisitor {
    Calls(ClassVisitor next) {
      super(Opcodes.ASM9, next);
    }

    @Override
    public void visit(
        int version, int access, String name, String signature, String parent, String[] faces) {
      String extended = RANDOM.equals(parent) ? CHANCE : parent;
      super.visit(version, access, name, signature, extended, faces);
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      return new Code(super.visitMethod(access, name, descriptor, signature, exceptions));
    }
  }

  private final class Code extends MethodVisitor {
    Code(MethodVisitor next) {
      super(Opcodes.ASM9, next);
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
      boolean isStatic = opcode == Opcodes.INVOKESTATIC;
      String standIn = isStatic ? staticStandIn(owner, name, descriptor) : null;
      String ofObject = headless ? OF_OBJECTS.get(owner + "." + name + descriptor) : null;
      if (standIn != null) {
        call(standIn, descriptor);
      } else if (opcode == Opcodes.INVOKEVIRTUAL && ofObject != null) {
        call(ofObject, "(L" + owner + ";" + descriptor.substring(1));
      } else if (opcode == Opcodes.INVOKESPECIAL
          && owner.equals(RANDOM)
          && name.equals(CONSTRUCTOR)) {
        super.visitMethodInsn(opcode, CHANCE, name, descriptor, false);
      } else if (isLeftOut(isStatic, owner, name, descriptor)) {
        leaveOut(descriptor, isStatic);
      } else {
        super.visitMethodInsn(opcode, owner, name, descriptor, isInterface);
      }
    }

    private @Nullable String staticStandIn(String owner, String name, String descriptor) {
      String key = owner + "." + name + descriptor;
      String always = ALWAYS.get(key);
      return always == null && headless ? HEADLESS.get(key) : always;
    }

    private void call(String standIn, String descriptor) {
      super.visitMethodInsn(Opcodes.INVOKESTATIC, STAND_INS, standIn, descriptor, false);
    }

    private boolean isLeftOut(boolean isStatic, String owner, String name, String descriptor) {
      if (!headless || name.equals(CONSTRUCTOR)) {
        return false;
      }
      return isStatic
          ? owner.equals(DIALOGS) && name.startsWith("show")
          : windows.lacks(owner, name, descriptor);
    }

    /** Takes the arguments, and the object, off the stack and answers 0, false or null. */
    private void leaveOut(String descriptor, boolean isStatic) {
      Type[] arguments = Type.getArgumentTypes(descriptor);
      for (int i = arguments.length - 1; i >= 0; i--) {
        super.visitInsn(arguments[i].getSize() == 2 ? Opcodes.POP2 : Opcodes.POP);
      }
      if (!isStatic) {
        super.visitInsn(Opcodes.POP);
      }
      switch (Type.getReturnType(descriptor).getSort()) {
        case Type.VOID -> {}
        case Type.LONG -> super.visitInsn(Opcodes.LCONST_0);
        case Type.DOUBLE -> super.visitInsn(Opcodes.DCONST_0);
        case Type.FLOAT -> super.visitInsn(Opcodes.FCONST_0);
        case Type.OBJECT, Type.ARRAY -> super.visitInsn(Opcodes.ACONST_NULL);
        default -> super.visitInsn(Opcodes.ICONST_0);
      }
    }

    /** {@code Math::random} and its like. */
    @Override
    public void visitInvokeDynamicInsn(
        String name, String descriptor, Handle bootstrap, Object... arguments) {
      Object[] sent = arguments.clone();
      for (int i = 0; i < sent.length; i++) {
        sent[i] = arguments[i] instanceof Handle handle ? standIn(handle) : arguments[i];
      }
      super.visitInvokeDynamicInsn(name, descriptor, bootstrap, sent);
    }

    private Handle standIn(Handle handle) {
      String owner = handle.getOwner();
      String descriptor = handle.getDesc();
      if (handle.getTag() == Opcodes.H_NEWINVOKESPECIAL && owner.equals(RANDOM)) {
        return new Handle(handle.getTag(), CHANCE, CONSTRUCTOR, descriptor, false);
      }
      boolean isStatic = handle.getTag() == Opcodes.H_INVOKESTATIC;
      String standIn = isStatic ? staticStandIn(owner, handle.getName(), descriptor) : null;
      return standIn == null
          ? handle
          : new Handle(handle.getTag(), STAND_INS, standIn, descriptor, false);
    }
  }
}
