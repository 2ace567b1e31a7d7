package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * A point seen from above, in the world's frame or an obstacle's own.
 *
 * @param xM to the right, in metres
 * @param zM down the page, in metres
 */
public record Point(double xM, double zM) {
  /** Refuses what is no such thing. */
  public Point {
    Checks.finite("x", xM);
    Checks.finite("z", zM);
  }
}
