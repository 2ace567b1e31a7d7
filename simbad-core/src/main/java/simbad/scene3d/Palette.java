package simbad.scene3d;

import javax.vecmath.Color3f;
import simbad.kernel.drawing.Rgb;

/** The colours of what the window adds to a world, on light floors and on dark ones. */
public enum Palette {
  /** For light floors. */
  LIGHT(0.80f, 0.80f, 0x000000, 0x7A3B00, 0x1238C8),
  /** For dark floors. */
  DARK(0.11f, 0.13f, 0xFFFFFF, 0xF0B460, 0x7FB4FF);

  /** Half way between black and white as screens show them: there white is seen better. */
  private static final float DARK_BELOW = 0.46f;

  private final float background;
  private final float floor;
  private final int grid;
  private final int edge;
  private final int trail;

  Palette(float background, float floor, int grid, int edge, int trail) {
    this.background = background;
    this.floor = floor;
    this.grid = grid;
    this.edge = edge;
    this.trail = trail;
  }

  /** Returns the palette that goes with a look. */
  public static Palette of(Look look) {
    return look.dark() ? DARK : LIGHT;
  }

  /** Returns true if lines on a floor of this colour have to be light. */
  static boolean isDark(Rgb floor) {
    return 0.2126f * floor.red() + 0.7152f * floor.green() + 0.0722f * floor.blue() < DARK_BELOW;
  }

  /** Returns what is seen where nothing is. */
  Rgb background() {
    return grey(background);
  }

  /** Returns the colour of a floor for which the program has chosen none. */
  Rgb floor() {
    return grey(floor);
  }

  private static Rgb grey(float share) {
    return new Rgb(share, share, share);
  }

  Color3f grid() {
    return color(grid);
  }

  /** Returns the red, green and blue of a shadow's edge as one number. */
  public int edgeRgb() {
    return edge;
  }

  Color3f edge() {
    return color(edge);
  }

  /** Returns the red, green and blue of a trail as one number. */
  public int trailRgb() {
    return trail;
  }

  Color3f trail() {
    return color(trail);
  }

  private static Color3f color(int rgb) {
    return new Color3f(new java.awt.Color(rgb));
  }
}
