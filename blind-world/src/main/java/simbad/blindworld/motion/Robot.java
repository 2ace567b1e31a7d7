package simbad.blindworld.motion;

import simbad.blindworld.check.Checks;

/**
 * What the simulator believes of a robot: robot.json.
 *
 * @param wheelRadiusM 0 for a unicycle
 * @param wheelBaseM distance of the wheels; for a unicycle that of the real ones, which nobody told
 * @param differential whether commands are of the wheels' rims
 * @param beliefs how commands are believed to act
 * @param tracker what is said of the tracker's scatter
 * @param separateClocks whether track and commands are said to have clocks of their own
 */
public record Robot(
    double wheelRadiusM,
    double wheelBaseM,
    boolean differential,
    Beliefs beliefs,
    Scatter tracker,
    boolean separateClocks) {
  /** Refuses what is no such thing. */
  public Robot {
    Checks.notNegative("wheel radius", wheelRadiusM);
    Checks.notNegative("wheel base", wheelBaseM);
  }

  /**
   * How commands are believed to act; 0 for at once, infinite for no limit.
   *
   * @param latencyS by which all commands act late
   * @param timeConstantS of both speeds
   * @param maxSpeedMPerS greatest speed
   * @param maxTurnRadPerS greatest turn rate
   */
  public record Beliefs(
      double latencyS, double timeConstantS, double maxSpeedMPerS, double maxTurnRadPerS) {
    /** Refuses what is no such thing. */
    public Beliefs {
      Checks.notNegative("latency", latencyS);
      Checks.notNegative("time constant", timeConstantS);
      Checks.limit("greatest speed", maxSpeedMPerS);
      Checks.limit("greatest turn rate", maxTurnRadPerS);
    }

    /** At once and without limits. */
    public static final Beliefs NONE =
        new Beliefs(0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
  }

  /**
   * Standard deviations of a tracker.
   *
   * @param positionM of x and of z
   * @param headingRad of the heading
   */
  public record Scatter(double positionM, double headingRad) {
    /** Refuses what is no such thing. */
    public Scatter {
      Checks.notNegative("scatter of places", positionM);
      Checks.notNegative("scatter of headings", headingRad);
    }

    /** A tracker that is always right. */
    public static final Scatter NONE = new Scatter(0, 0);
  }

  /** The robot with another statement of its tracker. */
  public Robot withTracker(Scatter stated) {
    return new Robot(wheelRadiusM, wheelBaseM, differential, beliefs, stated, separateClocks);
  }
}
