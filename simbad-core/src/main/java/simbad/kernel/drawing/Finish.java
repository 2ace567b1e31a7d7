package simbad.kernel.drawing;

/**
 * The surface of some triangles.
 *
 * @param colour its colour
 * @param lit true if it is as bright as the lights make it, see {@link Lighting}; false if it
 *     always shows its colour
 */
public record Finish(Rgb colour, boolean lit) {
  /** Returns a surface that light falls on. */
  public static Finish lit(Rgb colour) {
    return new Finish(colour, true);
  }

  /** Returns a surface that shows its colour whatever the lights are. */
  public static Finish plain(Rgb colour) {
    return new Finish(colour, false);
  }
}
