package simbad.sonar.frame;

/**
 * Where a sensor stands as seen from an obstacle, in the obstacle's own frame: 0 along its +z, a
 * quarter turn along its +x.
 *
 * @param radians the angle, normalised to [0, 2 pi)
 */
public record Bearing(double radians) {
  /** Normalises the angle; one that is not finite is refused. */
  public Bearing {
    radians = Angles.positive(radians);
  }

  /**
   * Creates one from degrees.
   *
   * @param degrees any finite angle
   */
  public static Bearing ofDegrees(double degrees) {
    return new Bearing(Math.toRadians(degrees));
  }

  /** Returns the angle in degrees. */
  public double degrees() {
    return Math.toDegrees(radians);
  }
}
