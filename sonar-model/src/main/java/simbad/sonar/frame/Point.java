package simbad.sonar.frame;

import simbad.sonar.check.Checks;

/**
 * A place on the plane.
 *
 * @param xM to the right, metres, finite
 * @param zM down the page, metres, finite
 */
public record Point(double xM, double zM) {
  /** Checks that both coordinates are finite. */
  public Point {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
  }

  /** Returns the distance to another point in metres. */
  public double distanceM(Point other) {
    return Math.hypot(xM - other.xM, zM - other.zM);
  }
}
