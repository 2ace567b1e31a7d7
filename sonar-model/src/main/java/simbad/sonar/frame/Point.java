package simbad.sonar.frame;

/**
 * A place on the plane.
 *
 * @param xM to the right, metres, finite
 * @param zM down the page, metres, finite
 */
public record Point(double xM, double zM) {
  /** Checks that both coordinates are finite. */
  public Point {
    requireFinite("xM", xM);
    requireFinite("zM", zM);
  }

  /** Returns the distance to another point in metres. */
  public double distanceM(Point other) {
    return Math.hypot(xM - other.xM, zM - other.zM);
  }

  static void requireFinite(String name, double value) {
    if (!(Math.abs(value) < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " = " + value + " is not finite");
    }
  }
}
