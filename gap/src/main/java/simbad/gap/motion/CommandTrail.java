package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.motion.Command;

/** Looks into a run's commands. */
final class CommandTrail {
  private CommandTrail() {}

  /** Returns the index of the first command that is not before a time. */
  private static int first(List<Command> commands, double timeS) {
    int low = 0;
    int high = commands.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (commands.get(middle).timeS() < timeS) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Returns the command that is held at a time; before the first one, that. */
  static Command held(List<Command> commands, double timeS) {
    return commands.get(Math.max(0, first(commands, Math.nextUp(timeS)) - 1));
  }

  /**
   * Returns the commands that act between two times.
   *
   * @param commands of a run
   * @param fromS from when; what was held then is given then
   * @param toS till when, not before
   */
  static List<Command> between(List<Command> commands, double fromS, double toS) {
    Command held = held(commands, fromS);
    List<Command> own = new ArrayList<>();
    own.add(new Command(Math.max(fromS, held.timeS()), held.speedMPerS(), held.turnRadPerS()));
    int start = first(commands, Math.nextUp(own.get(0).timeS()));
    own.addAll(commands.subList(start, Math.max(start, first(commands, Math.nextUp(toS)))));
    return own;
  }

  /**
   * Returns the sum of the squares by which a command changes between two times.
   *
   * @param commands of a run
   * @param turns whether the turn's command is meant, not the speed's
   * @param fromS from when
   * @param toS till when
   */
  static double changed(List<Command> commands, boolean turns, double fromS, double toS) {
    double sum = 0;
    for (int k = Math.max(1, first(commands, fromS)); k < commands.size(); k++) {
      Command now = commands.get(k);
      if (now.timeS() > toS) {
        break;
      }
      Command before = commands.get(k - 1);
      double by =
          turns ? now.turnRadPerS() - before.turnRadPerS() : now.speedMPerS() - before.speedMPerS();
      sum += by * by;
    }
    return sum;
  }
}
