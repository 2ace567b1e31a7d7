package simbad.motion;

import java.util.List;

/**
 * The mean speed and the mean rate of turning that commands ask for in each step of a grid. Held
 * commands make these exact wherever a command changes within a step.
 *
 * @param speeds by step, m/s; the first is of no step and 0
 * @param turns the same of the rates, rad/s
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by step, never compared.
record CommandSeries(double[] speeds, double[] turns) {
  private static final double PER_S = 1 / Way.STEP_S;

  /**
   * Computes the means; before the first command the robot stands.
   *
   * @param commands in order of time
   * @param startS where the first step begins
   * @param size one more than steps
   */
  static CommandSeries of(Held commands, double startS, int size) {
    CommandSeries series = new CommandSeries(new double[size], new double[size]);
    series.fill(commands, startS);
    return series;
  }

  /**
   * Computes the means of other commands in the place of these.
   *
   * @param commands in order of time
   * @param startS where the first step begins
   */
  void fill(Held commands, double startS) {
    int next = 0;
    while (commands.timeS(next) <= startS) {
      next++;
    }
    double endS = startS;
    for (int i = 1; i < speeds.length; i++) {
      double fromS = endS;
      endS = startS + i * Way.STEP_S;
      if (commands.timeS(next) > endS) {
        speeds[i] = commands.speed(next - 1);
        turns[i] = commands.turn(next - 1);
        continue;
      }
      double way = 0;
      double angle = 0;
      for (; commands.timeS(next) <= endS; next++) {
        double held = commands.timeS(next) - fromS;
        way += commands.speed(next - 1) * held;
        angle += commands.turn(next - 1) * held;
        fromS = commands.timeS(next);
      }
      speeds[i] = (way + commands.speed(next - 1) * (endS - fromS)) * PER_S;
      turns[i] = (angle + commands.turn(next - 1) * (endS - fromS)) * PER_S;
    }
  }

  /** Puts in the place of these means how speeds follow others of the same length. */
  void follow(CommandSeries asked, List<Response> responses) {
    System.arraycopy(asked.speeds, 0, speeds, 0, speeds.length);
    System.arraycopy(asked.turns, 0, turns, 0, turns.length);
    follow(responses);
  }

  /** Puts in the place of these means how speeds follow them, by responses in series. */
  void follow(List<Response> responses) {
    for (Response response : responses) {
      response.over(Way.STEP_S).follow(speeds, turns);
    }
  }
}
