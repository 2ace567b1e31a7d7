package simbad.sonar.frame;

/**
 * How far to one side of a sensor's heading something lies: positive counter-clockwise.
 *
 * @param radians the angle, normalised to (-pi, pi]
 */
public record OffAxisAngle(double radians) {
  /** Normalises the angle; one that is not finite is refused. */
  public OffAxisAngle {
    radians = Angles.signed(radians);
  }

  /**
   * Creates one from degrees.
   *
   * @param degrees any finite angle
   */
  public static OffAxisAngle ofDegrees(double degrees) {
    return new OffAxisAngle(Math.toRadians(degrees));
  }

  /** Returns the angle in degrees. */
  public double degrees() {
    return Math.toDegrees(radians);
  }
}
