package simbad.sonar.frame;

/**
 * Where something looks or drives to: counter-clockwise from +x, so that (x, z) = (cos h, -sin h).
 *
 * @param radians the angle, normalised to (-pi, pi]
 */
public record Heading(double radians) {
  /** Normalises the angle; one that is not finite is refused. */
  public Heading {
    radians = Angles.signed(radians);
  }

  /**
   * Creates one from degrees.
   *
   * @param degrees any finite angle
   */
  public static Heading ofDegrees(double degrees) {
    return new Heading(Math.toRadians(degrees));
  }

  /** Returns the angle in degrees. */
  public double degrees() {
    return Math.toDegrees(radians);
  }
}
