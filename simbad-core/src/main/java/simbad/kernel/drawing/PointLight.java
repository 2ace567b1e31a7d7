package simbad.kernel.drawing;

import simbad.sonar.check.Checks;

/**
 * A lamp that shines equally in all directions, and equally far: see {@link Lighting}.
 *
 * @param xM where it is, metres
 * @param yM its height, metres
 * @param zM where it is, metres
 * @param colour its colour
 */
public record PointLight(double xM, double yM, double zM, Rgb colour) {
  /** Checks the position. */
  public PointLight {
    Checks.finite("xM", xM);
    Checks.finite("yM", yM);
    Checks.finite("zM", zM);
  }
}
