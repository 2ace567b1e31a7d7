package simbad.sim;

/** A rectangle of numbers, row 0 on top: an image in gray, for example. */
public class SensorMatrix extends SensorData {
  /** Number of columns; to be read only. */
  public int width;

  /** Number of rows; to be read only. */
  public int height;

  private final float[] values;
  private final boolean edgeThrows;

  /**
   * Creates a matrix of zeros.
   *
   * @param width number of columns; at least 0
   * @param height number of rows; at least 0
   */
  public SensorMatrix(int width, int height) {
    this(width, height, Compatibility.fromProperty().contains(Compatibility.MATRIX_EDGE_THROWS));
  }

  /** Creates a matrix of zeros whose right and lower edge can be asked, or not. */
  SensorMatrix(int width, int height, boolean edgeThrows) {
    this.width = width;
    this.height = height;
    this.edgeThrows = edgeThrows;
    values = new float[width * height];
  }

  /** Creates an independent copy. */
  public SensorMatrix(SensorMatrix from) {
    width = from.width;
    height = from.height;
    edgeThrows = from.edgeThrows;
    values = from.values.clone();
  }

  /** Returns the number of rows. */
  public int getHeight() {
    return height;
  }

  /** Returns the number of columns. */
  public int getWidth() {
    return width;
  }

  /** Returns the number in a column and a row, both from 0. */
  public float get(int x, int y) {
    return values[y * width + x];
  }

  /**
   * Returns the number at a place given by shares of the width and the height.
   *
   * @param x from 0, the left edge, to 1, the right edge
   * @param y from 0, the upper edge, to 1, the lower edge
   * @throws IndexOutOfBoundsException at an edge, 1, with {@link Compatibility#MATRIX_EDGE_THROWS}
   */
  public float get(float x, float y) {
    return get(index(x, width), index(y, height));
  }

  private int index(float share, int size) {
    if (edgeThrows && share >= 1) {
      throw new IndexOutOfBoundsException("share = " + share + " is not in [0, 1)");
    }
    return Math.min((int) (share * size), size - 1);
  }

  /** Returns the numbers themselves, row by row; what is written there is in the matrix. */
  public float[] getArray() {
    return values;
  }

  @Override
  public Object clone() {
    return new SensorMatrix(this);
  }
}
