package simbad.kernel.drawing;

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
    if (!Double.isFinite(xM) || !Double.isFinite(yM) || !Double.isFinite(zM)) {
      throw new IllegalArgumentException(
          "position = (" + xM + ", " + yM + ", " + zM + ") is not finite");
    }
  }
}
