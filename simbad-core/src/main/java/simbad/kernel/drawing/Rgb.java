package simbad.kernel.drawing;

/**
 * A colour or the strength of a light by its red, green and blue share.
 *
 * @param red in [0, 1]
 * @param green in [0, 1]
 * @param blue in [0, 1]
 */
public record Rgb(float red, float green, float blue) {
  /** White. */
  public static final Rgb WHITE = new Rgb(1, 1, 1);

  /** Checks the shares. */
  public Rgb {
    requireShare("red", red);
    requireShare("green", green);
    requireShare("blue", blue);
  }

  private static void requireShare(String name, float share) {
    if (!(share >= 0 && share <= 1)) {
      throw new IllegalArgumentException(name + " = " + share + " is not in [0, 1]");
    }
  }

  /** Creates the colour nearest to given shares, which may lie outside [0, 1]; NaN counts as 0. */
  public static Rgb nearest(float red, float green, float blue) {
    return new Rgb(clamp(red), clamp(green), clamp(blue));
  }

  private static float clamp(float share) {
    return share > 0 ? Math.min(1, share) : 0;
  }

  /** Returns 0.299 red + 0.587 green + 0.114 blue, as in ITU-R BT.601; in [0, 1]. */
  public double luminance() {
    return 0.299 * red + 0.587 * green + 0.114 * blue;
  }
}
