package simbad.motion;

import java.util.Arrays;
import java.util.List;

/**
 * The changes of a chain that say anything about a stage, for the thousand millions of steps of a
 * search: to ask all others what they leave as it is would take most of its time.
 *
 * @param commands that are changed
 * @param speeds over ground
 * @param turns over ground
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared.
record Stages(MotionChange[] commands, MotionChange[] speeds, MotionChange[] turns) {

  /** Which of the methods of a change its class has of its own. */
  private record Own(boolean commands, boolean speeds, boolean turns) {
    static Own of(Class<?> type) {
      return new Own(
          has(type, "commanded", Command.class)
              || has(type, "commandedSpeed", double.class)
              || has(type, "commandedTurn", double.class),
          has(type, "speed", double.class),
          has(type, "turn", double.class, double.class));
    }

    private static boolean has(Class<?> type, String method, Class<?>... arguments) {
      try {
        return type.getMethod(method, arguments).getDeclaringClass() != MotionChange.class;
      } catch (NoSuchMethodException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  private static final ClassValue<Own> OWN =
      new ClassValue<>() {
        @Override
        protected Own computeValue(Class<?> type) {
          return Own.of(type);
        }
      };

  static Stages of(MotionChain chain) {
    List<MotionChange> all = chain.changes();
    return new Stages(
        all.stream().filter(c -> own(c).commands).toArray(MotionChange[]::new),
        all.stream().filter(c -> own(c).speeds).toArray(MotionChange[]::new),
        all.stream().filter(c -> own(c).turns).toArray(MotionChange[]::new));
  }

  private static Own own(MotionChange change) {
    return OWN.get(change.getClass());
  }

  /** Returns the commands that the drive takes given ones for, in their order. */
  Command[] commanded(List<Command> given) {
    Command[] taken = given.toArray(Command[]::new);
    for (MotionChange change : commands) {
      Arrays.setAll(taken, i -> change.commanded(taken[i]));
    }
    return taken;
  }

  double speed(double speedMPerS) {
    double speed = speedMPerS;
    for (MotionChange change : speeds) {
      speed = change.speed(speed);
    }
    return speed;
  }

  double turn(double turnRadPerS, double speedMPerS) {
    double turn = turnRadPerS;
    for (MotionChange change : turns) {
      turn = change.turn(turn, speedMPerS);
    }
    return turn;
  }
}
