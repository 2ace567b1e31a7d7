package simbad.experiments.control;

/**
 * Parameters of the edge follower.
 *
 * @param speedMPerS of the robot while it moves, positive
 * @param stepS the simulator's time step, positive
 * @param greatestTurnRateRadPerS of the robot, positive
 * @param crossingAngleRad by which it steers towards the edge, in (0, pi/2)
 * @param curlRadPerStepM by how much its estimate of the edge's direction turns more in each step,
 *     per metre that one side has lasted; positive
 */
public record Tuning(
    double speedMPerS,
    double stepS,
    double greatestTurnRateRadPerS,
    double crossingAngleRad,
    double curlRadPerStepM) {
  /** The greatest rate of turning, radians per second: one turn per second. */
  public static final double TURN_RATE = 2 * Math.PI;

  private static final double ANY = Double.POSITIVE_INFINITY;

  /** A robot takes no bend faster, for what the tables show is a few centimetres small. */
  public static final double BEND_SPEED_M_PER_S = 0.02;

  /** Checks the parameters. */
  public Tuning {
    requireBetween("speedMPerS", speedMPerS, ANY);
    requireBetween("stepS", stepS, ANY);
    requireBetween("greatestTurnRateRadPerS", greatestTurnRateRadPerS, ANY);
    requireBetween("crossingAngleRad", crossingAngleRad, Math.PI / 2);
    requireBetween("curlRadPerStepM", curlRadPerStepM, ANY);
  }

  /**
   * Returns the parameters of the main experiment: one turn per second at most, 30 degrees towards
   * the edge, found by trial on the measured table of the angle.
   *
   * @param speedMPerS positive
   * @param stepS the simulator's time step, positive
   */
  public static Tuning standard(double speedMPerS, double stepS) {
    // The curl is per length of way, so that a faster robot drives a larger picture of the same
    // line.
    double stepM = speedMPerS * stepS;
    return new Tuning(speedMPerS, stepS, TURN_RATE, Math.toRadians(30), 0.01 / stepM);
  }

  /** Of the robot where it turns: a picture that grew with the speed would cut off corners. */
  double bendSpeedMPerS() {
    return Math.min(speedMPerS, BEND_SPEED_M_PER_S);
  }

  /** The same for a robot that goes no faster than it takes bends. */
  Tuning inBends() {
    double slower = bendSpeedMPerS() / speedMPerS;
    return new Tuning(
        bendSpeedMPerS(),
        stepS,
        greatestTurnRateRadPerS,
        crossingAngleRad,
        curlRadPerStepM / slower);
  }

  double curlRadPerStep() {
    return curlRadPerStepM * stepM();
  }

  double stepM() {
    return speedMPerS * stepS;
  }

  double mostRadPerStep() {
    return greatestTurnRateRadPerS * stepS;
  }

  private static void requireBetween(String name, double value, double below) {
    if (!(value > 0 && value < below)) {
      throw new IllegalArgumentException(name + " = " + value + " is not in (0, " + below + ")");
    }
  }
}
