package simbad.motion;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Commands as a drive takes them. A log asks for few different things many times: a change is asked
 * once of each.
 */
final class Held {
  private final double[] timesS;

  /** By command, which of the different ones it is. */
  private final int[] kinds;

  /** The different ones as they were given. */
  private final Command[] given;

  private final double[] speeds;
  private final double[] turns;

  private Held(double[] timesS, int[] kinds, Command[] given, Command[] taken) {
    this.timesS = timesS;
    this.kinds = kinds;
    this.given = given;
    speeds = new double[taken.length];
    turns = new double[taken.length];
    for (int k = 0; k < taken.length; k++) {
      speeds[k] = taken[k].speedMPerS();
      turns[k] = taken[k].turnRadPerS();
    }
  }

  /**
   * Returns commands as they are given.
   *
   * @param commands in order of time
   */
  static Held of(List<Command> commands) {
    Map<Asked, Integer> different = new LinkedHashMap<>();
    double[] timesS = new double[commands.size()];
    int[] kinds = new int[commands.size()];
    Command[] given = new Command[commands.size()];
    for (int i = 0; i < kinds.length; i++) {
      Command command = commands.get(i);
      timesS[i] = command.timeS();
      Asked asked = new Asked(command.speedMPerS(), command.turnRadPerS());
      kinds[i] = different.computeIfAbsent(asked, key -> different.size());
      given[kinds[i]] = command;
    }
    Command[] kept = Arrays.copyOf(given, different.size());
    return new Held(timesS, kinds, kept, kept);
  }

  /** What a command asks for. */
  private record Asked(double speedMPerS, double turnRadPerS) {}

  /**
   * Returns what a drive takes the same commands for.
   *
   * @param changes in the order in which they act
   */
  Held taken(Iterable<MotionChange> changes) {
    Command[] taken = given.clone();
    for (MotionChange change : changes) {
      for (int k = 0; k < taken.length; k++) {
        taken[k] = change.commanded(taken[k]);
      }
    }
    return new Held(timesS, kinds, given, taken);
  }

  /** Returns when a command is given; infinite behind the last. */
  double timeS(int index) {
    return index < timesS.length ? timesS[index] : Double.POSITIVE_INFINITY;
  }

  /** Returns the speed of a command; before the first the robot stands. */
  double speed(int index) {
    return index < 0 ? 0 : speeds[kinds[index]];
  }

  /** Returns the rate of turning of a command; before the first the robot stands. */
  double turn(int index) {
    return index < 0 ? 0 : turns[kinds[index]];
  }
}
