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

  /** The different ones. */
  private final Command[] commands;

  private final double[] speeds;
  private final double[] turns;

  private Held(double[] timesS, int[] kinds, Command[] commands) {
    this.timesS = timesS;
    this.kinds = kinds;
    this.commands = commands;
    speeds = new double[commands.length];
    turns = new double[commands.length];
    for (int k = 0; k < commands.length; k++) {
      speeds[k] = commands[k].speedMPerS();
      turns[k] = commands[k].turnRadPerS();
    }
  }

  /**
   * Returns commands as they are given.
   *
   * @param commands in order of time
   */
  static Held of(List<Command> commands) {
    return of(
        commands.stream().mapToDouble(Command::timeS).toArray(), commands.toArray(Command[]::new));
  }

  private static Held of(double[] timesS, Command[] commands) {
    Map<Asked, Integer> different = new LinkedHashMap<>();
    int[] kinds = new int[commands.length];
    Command[] kept = new Command[commands.length];
    for (int i = 0; i < kinds.length; i++) {
      Command command = commands[i];
      Asked asked = new Asked(command.speedMPerS(), command.turnRadPerS());
      kinds[i] = different.computeIfAbsent(asked, key -> different.size());
      kept[kinds[i]] = command;
    }
    return new Held(timesS, kinds, Arrays.copyOf(kept, different.size()));
  }

  /** What a command asks for. */
  private record Asked(double speedMPerS, double turnRadPerS) {}

  /**
   * Returns what a drive takes the same commands for.
   *
   * @param changes in the order in which they act
   */
  Held taken(Iterable<MotionChange> changes) {
    Held held = this;
    for (MotionChange change : changes) {
      held = change.remembers() ? held.takenInTurn(change) : held.taken(change);
    }
    return held;
  }

  private Held taken(MotionChange change) {
    Command[] taken = new Command[commands.length];
    Arrays.setAll(taken, k -> change.commanded(commands[k]));
    return new Held(timesS, kinds, taken);
  }

  /** Each command after the one before it. */
  private Held takenInTurn(MotionChange change) {
    Command[] taken = new Command[timesS.length];
    Command before = Command.STAND;
    for (int i = 0; i < taken.length; i++) {
      before = change.commanded(commands[kinds[i]], before);
      taken[i] = before;
    }
    return of(timesS, taken);
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
