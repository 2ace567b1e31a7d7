package simbad.figures.plot;

import simbad.sonar.check.Checks;

/**
 * A point seen from the obstacle's centre, in the obstacle's own frame.
 *
 * @param bearingRad the direction in radians, 0 along +z, a quarter turn along +x; finite
 * @param radiusM the distance from the centre in metres; finite, at least 0
 */
public record PolarPoint(double bearingRad, double radiusM) {
  /** Checks both numbers. */
  public PolarPoint {
    Checks.finite("bearingRad", bearingRad);
    Checks.notNegative("radiusM", radiusM);
  }

  /**
   * The point at an offset from the obstacle's centre; the centre itself has bearing 0.
   *
   * @param xM offset along the obstacle's +x in metres
   * @param zM offset along the obstacle's +z in metres
   */
  public static PolarPoint ofOffset(double xM, double zM) {
    return new PolarPoint(Math.atan2(xM, zM), Math.hypot(xM, zM));
  }

  /** The offset along +x (to the right of the page), in metres. */
  public double xM() {
    return radiusM * Math.sin(bearingRad);
  }

  /** The offset along +z (down the page), in metres. */
  public double zM() {
    return radiusM * Math.cos(bearingRad);
  }
}
