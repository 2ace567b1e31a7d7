package simbad.kernel.render;

import java.util.Arrays;

/** A colour picture, row 0 on top. A mutable buffer, black when made. */
public final class Picture {
  private static final int OPAQUE = 0xff000000;

  private final int width;
  private final int height;
  private final int[] argb;

  /**
   * Creates a black picture.
   *
   * @param width columns; at least 1
   * @param height rows; at least 1
   */
  public Picture(int width, int height) {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException("size = " + width + " x " + height + " is not at least 1");
    }
    this.width = width;
    this.height = height;
    argb = new int[width * height];
    clear();
  }

  /** Becomes a copy of another picture of the same size. */
  public void copyFrom(Picture other) {
    if (other.width != width || other.height != height) {
      throw new IllegalArgumentException(
          "size = " + other.width + " x " + other.height + " is not " + width + " x " + height);
    }
    System.arraycopy(other.argb, 0, argb, 0, argb.length);
  }

  /** Becomes black. */
  public void clear() {
    Arrays.fill(argb, OPAQUE);
  }

  /** Returns the number of columns. */
  public int width() {
    return width;
  }

  /** Returns the number of rows. */
  public int height() {
    return height;
  }

  /**
   * Returns the pixels themselves, row by row, each 0xAARRGGBB with AA = 255; what is written there
   * is in the picture.
   */
  public int[] argb() {
    return argb;
  }

  /** Returns a pixel as 0xRRGGBB. */
  public int rgb(int column, int row) {
    return argb[row * width + column] & ~OPAQUE;
  }

  /** Returns a pixel's mean of red, green and blue, in [0, 1]. */
  public float gray(int column, int row) {
    int rgb = rgb(column, row);
    return (red(rgb) + green(rgb) + blue(rgb)) / (3f * 255);
  }

  /**
   * Returns the mean luminance over all pixels, in [0, 1]: 0.299 red + 0.587 green + 0.114 blue, as
   * in ITU-R BT.601.
   */
  public float luminance() {
    long red = 0;
    long green = 0;
    long blue = 0;
    for (int rgb : argb) {
      red += red(rgb);
      green += green(rgb);
      blue += blue(rgb);
    }
    return (float) ((0.299 * red + 0.587 * green + 0.114 * blue) / (255.0 * argb.length));
  }

  private static int red(int rgb) {
    return rgb >> 16 & 0xff;
  }

  private static int green(int rgb) {
    return rgb >> 8 & 0xff;
  }

  private static int blue(int rgb) {
    return rgb & 0xff;
  }
}
