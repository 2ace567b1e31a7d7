package simbad.motion;

import java.util.Arrays;

/**
 * A run's commands as the way and the turn that they ask for up to a time. Held commands make these
 * piecewise straight, so the mean command of a step is exact wherever the step lies.
 */
final class CommandSeries {
  private final double[] timesS;
  private final double[] speeds;
  private final double[] turns;
  private final double[] ways;
  private final double[] angles;

  CommandSeries(Command[] commands) {
    int n = commands.length;
    timesS = new double[n];
    speeds = new double[n];
    turns = new double[n];
    ways = new double[n];
    angles = new double[n];
    for (int i = 0; i < n; i++) {
      Command command = commands[i];
      timesS[i] = command.timeS();
      speeds[i] = command.speedMPerS();
      turns[i] = command.turnRadPerS();
      if (i > 0) {
        double held = timesS[i] - timesS[i - 1];
        ways[i] = ways[i - 1] + speeds[i - 1] * held;
        angles[i] = angles[i - 1] + turns[i - 1] * held;
      }
    }
  }

  /** Before the first command the robot stands. */
  int index(double timeS) {
    int at = Arrays.binarySearch(timesS, timeS);
    return at >= 0 ? at : -at - 2;
  }

  /** Moves an index that was right for an earlier time. */
  int forward(int index, double timeS) {
    int at = index;
    while (at + 1 < timesS.length && timesS[at + 1] <= timeS) {
      at++;
    }
    return at;
  }

  double way(int index, double timeS) {
    return index < 0 ? 0 : ways[index] + speeds[index] * (timeS - timesS[index]);
  }

  double angle(int index, double timeS) {
    return index < 0 ? 0 : angles[index] + turns[index] * (timeS - timesS[index]);
  }
}
