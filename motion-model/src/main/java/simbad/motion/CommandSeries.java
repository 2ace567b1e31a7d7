package simbad.motion;

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
  static CommandSeries of(Command[] commands, double startS, int size) {
    double[] speeds = new double[size];
    double[] turns = new double[size];
    Command held = new Command(startS, 0, 0);
    int next = 0;
    for (; next < commands.length && commands[next].timeS() <= startS; next++) {
      held = commands[next];
    }
    double nextS = timeS(commands, next);
    double endS = startS;
    for (int i = 1; i < size; i++) {
      double fromS = endS;
      endS = startS + i * Way.STEP_S;
      if (nextS > endS) {
        speeds[i] = held.speedMPerS();
        turns[i] = held.turnRadPerS();
        continue;
      }
      double way = 0;
      double angle = 0;
      for (; nextS <= endS; nextS = timeS(commands, ++next)) {
        way += held.speedMPerS() * (nextS - fromS);
        angle += held.turnRadPerS() * (nextS - fromS);
        fromS = nextS;
        held = commands[next];
      }
      speeds[i] = (way + held.speedMPerS() * (endS - fromS)) * PER_S;
      turns[i] = (angle + held.turnRadPerS() * (endS - fromS)) * PER_S;
    }
    return new CommandSeries(speeds, turns);
  }

  private static double timeS(Command[] commands, int index) {
    return index < commands.length ? commands[index].timeS() : Double.POSITIVE_INFINITY;
  }
}
