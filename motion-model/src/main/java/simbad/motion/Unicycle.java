package simbad.motion;

/**
 * The nominal motion: the exact arc of a body that goes and turns with speeds that are held. Two
 * driven wheels do the same with the mean of their rims' speeds and the difference over the base.
 */
public final class Unicycle {
  /** Below it the arc's formula would lose digits to cancellation. */
  private static final double STRAIGHT_RAD = 1e-6;

  private Unicycle() {}

  /**
   * Returns the pose after a time.
   *
   * @param pose at the start
   * @param speedMPerS along the heading
   * @param turnRadPerS counter-clockwise
   * @param durationS at least 0
   */
  public static TrackPose advance(
      TrackPose pose, double speedMPerS, double turnRadPerS, double durationS) {
    double turn = turnRadPerS * durationS;
    double chord = speedMPerS * durationS * chordShare(turn);
    double heading = pose.headingRad() + turn / 2;
    return new TrackPose(
        pose.timeS() + durationS,
        pose.xM() + chord * Math.cos(heading),
        pose.yM() + chord * Math.sin(heading),
        pose.headingRad() + turn);
  }

  /** Returns the length of an arc's chord as a share of the arc, for the angle it turns through. */
  static double chordShare(double turnRad) {
    double half = Math.abs(turnRad) / 2;
    return half < STRAIGHT_RAD ? 1 : Math.sin(half) / half;
  }

  /** Returns the body's speed with these speeds of the wheels' rims, m/s. */
  public static double speedOfWheels(double leftMPerS, double rightMPerS) {
    return (leftMPerS + rightMPerS) / 2;
  }

  /**
   * Returns the rate of turning with these speeds of the wheels' rims, rad/s.
   *
   * @param leftMPerS left rim
   * @param rightMPerS right rim
   * @param wheelBaseM between the wheels; above 0
   */
  public static double turnOfWheels(double leftMPerS, double rightMPerS, double wheelBaseM) {
    if (!(wheelBaseM > 0)) {
      throw new IllegalArgumentException("wheelBaseM = " + wheelBaseM + " is not in (0, infinity)");
    }
    return (rightMPerS - leftMPerS) / wheelBaseM;
  }
}
