package simbad.kernel.render;

import java.util.Arrays;

/**
 * Vertices in an eye's frame with their colours, {@value #STRIDE} numbers each: depth, right and up
 * in metres, then red, green and blue in [0, 1].
 */
final class Vertices {
  static final int STRIDE = 6;

  private double[] values = new double[32 * STRIDE];

  /** Makes room; what was there may be lost. */
  void reserve(int vertices) {
    if (values.length < vertices * STRIDE) {
      values = Arrays.copyOf(values, 2 * vertices * STRIDE);
    }
  }

  void setPlace(int vertex, double depthM, double rightM, double upM) {
    int at = vertex * STRIDE;
    values[at] = depthM;
    values[at + 1] = rightM;
    values[at + 2] = upM;
  }

  void setColour(int vertex, double red, double green, double blue) {
    int at = vertex * STRIDE + 3;
    values[at] = red;
    values[at + 1] = green;
    values[at + 2] = blue;
  }

  void copy(int vertex, Vertices from, int fromVertex) {
    System.arraycopy(from.values, fromVertex * STRIDE, values, vertex * STRIDE, STRIDE);
  }

  /** Sets a vertex between two of another buffer: share 0 is the first, 1 the second. */
  void mix(int vertex, Vertices from, int first, int second, double share) {
    for (int i = 0; i < STRIDE; i++) {
      double a = from.values[first * STRIDE + i];
      double b = from.values[second * STRIDE + i];
      values[vertex * STRIDE + i] = a + share * (b - a);
    }
  }

  double depthM(int vertex) {
    return values[vertex * STRIDE];
  }

  double rightM(int vertex) {
    return values[vertex * STRIDE + 1];
  }

  double upM(int vertex) {
    return values[vertex * STRIDE + 2];
  }

  /** Returns a share of a vertex' colour: channel 0 is red, 1 green, 2 blue. */
  double colour(int vertex, int channel) {
    return values[vertex * STRIDE + 3 + channel];
  }
}
