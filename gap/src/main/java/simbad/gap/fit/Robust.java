package simbad.gap.fit;

import java.util.Arrays;

/** Figures of a sample that a few wrong values do not move. */
public final class Robust {
  /** Of a normal distribution: its standard deviation over its median absolute deviation. */
  public static final double NORMAL_OVER_MAD = 1.4826;

  private Robust() {}

  /** Returns the median; not a number for no values. */
  public static double median(double... values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    return n == 0 ? Double.NaN : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
  }

  /**
   * Returns the median of the slopes between all pairs of points (Theil 1950, Sen 1968); not a
   * number where no two differ in x by enough.
   *
   * @param x as many as y
   * @param y in the order of x
   * @param apart pairs whose x differ by no more than this have no slope
   */
  public static double medianSlope(double[] x, double[] y, double apart) {
    double[] slopes = new double[x.length * (x.length - 1) / 2];
    int size = 0;
    for (int i = 0; i < x.length; i++) {
      for (int j = 0; j < i; j++) {
        if (Math.abs(x[i] - x[j]) > apart) {
          slopes[size++] = (y[i] - y[j]) / (x[i] - x[j]);
        }
      }
    }
    return median(Arrays.copyOf(slopes, size));
  }
}
