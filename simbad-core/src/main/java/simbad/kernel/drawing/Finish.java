package simbad.kernel.drawing;

/**
 * The surface of some triangles.
 *
 * @param colour its colour, which it reflects of the lamps' light
 * @param ambient what it reflects of the light from everywhere
 * @param lit true if it is as bright as the lights make it, see {@link Lighting}; false if it
 *     always shows its colour
 */
public record Finish(Rgb colour, Rgb ambient, boolean lit) {
  private static final Rgb GRAY = new Rgb(0.2f, 0.2f, 0.2f);

  /** Returns a surface that light falls on; of the light from everywhere it reflects 0.2. */
  public static Finish lit(Rgb colour) {
    return new Finish(colour, GRAY, true);
  }

  /**
   * Returns this surface with another answer to the light from everywhere: a share of its colour.
   */
  public Finish reflecting(float share) {
    Rgb some = new Rgb(share * colour.red(), share * colour.green(), share * colour.blue());
    return new Finish(colour, some, lit);
  }

  /** Returns a surface that shows its colour whatever the lights are. */
  public static Finish plain(Rgb colour) {
    return new Finish(colour, GRAY, false);
  }
}
