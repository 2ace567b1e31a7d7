package simbad.sonar.frame;

/** Normalises angles; each method names its interval. */
public final class Angles {
  /** One turn in radians. */
  public static final double TURN_RAD = 2 * Math.PI;

  private Angles() {}

  /**
   * Returns the angle of the same direction in (-pi, pi].
   *
   * @param radians any finite angle
   * @throws IllegalArgumentException if it is not finite
   */
  public static double signed(double radians) {
    requireFinite(radians);
    double within = Math.IEEEremainder(radians, TURN_RAD);
    return within <= -Math.PI ? Math.PI : unsignedZero(within);
  }

  /**
   * Returns the angle of the same direction in [0, 2 pi).
   *
   * @param radians any finite angle
   * @throws IllegalArgumentException if it is not finite
   */
  public static double positive(double radians) {
    requireFinite(radians);
    double within = radians % TURN_RAD;
    double positive = within < 0 ? within + TURN_RAD : within;
    // A tiny negative angle rounds up to a full turn, which is the direction 0.
    return positive >= TURN_RAD ? 0 : unsignedZero(positive);
  }

  /** Records compare -0.0 and 0.0 as different; as directions they are one. */
  private static double unsignedZero(double radians) {
    return radians + 0.0;
  }

  private static void requireFinite(double radians) {
    if (!(Math.abs(radians) < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("angle = " + radians + " rad is not finite");
    }
  }
}
