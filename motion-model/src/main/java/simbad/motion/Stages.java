package simbad.motion;

import java.util.ArrayList;
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
              || has(type, "commanded", Command.class, Command.class)
              || has(type, "commandedSpeed", double.class)
              || has(type, "commandedTurn", double.class),
          has(type, "speed", double.class, double.class),
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
    List<MotionChange> commands = new ArrayList<>();
    List<MotionChange> speeds = new ArrayList<>();
    List<MotionChange> turns = new ArrayList<>();
    for (MotionChange change : chain.changes()) {
      Own own = OWN.get(change.getClass());
      addIf(own.commands, change, commands);
      addIf(own.speeds, change, speeds);
      addIf(own.turns, change, turns);
    }
    return new Stages(array(commands), array(speeds), array(turns));
  }

  private static void addIf(boolean has, MotionChange change, List<MotionChange> to) {
    if (has) {
      to.add(change);
    }
  }

  private static MotionChange[] array(List<MotionChange> changes) {
    return changes.toArray(MotionChange[]::new);
  }

  double speed(double speedMPerS, double turnRadPerS) {
    double speed = speedMPerS;
    for (MotionChange change : speeds) {
      speed = change.speed(speed, turnRadPerS);
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
