package simbad.gap.audit;

import java.util.Arrays;
import org.hipparchus.distribution.continuous.TDistribution;
import simbad.gap.fit.Robust;

/**
 * A line through points of which some are wrong: the median of the slopes of all pairs (Theil 1950,
 * Sen 1968) finds those that lie on it, least squares through these give its slope with an
 * interval. The median stands up to 29 % of wrong points.
 *
 * @param slope of the line
 * @param offset its value at 0
 * @param halfWidth of the slope's interval
 * @param share of the points that lie on it
 */
record RobustLine(double slope, double offset, double halfWidth, double share) {
  /** What is read is what is there. */
  static final RobustLine IDENTITY = new RobustLine(1, 0, 0, 1);

  /** In scaled median deviations: further off is not on the line. */
  private static final double OUTLYING = 3.5;

  /** Files have tenths of a millimetre. */
  private static final double ROUNDED_M = 5e-5;

  private static final int LEAST_POINTS = 4;

  /**
   * Fits a line.
   *
   * @param x as many as y, not all alike
   * @param y in any order, but that of x
   * @param least scatter that points have on a line of slope 1; on a flatter one they have less
   * @param level that the interval misses the slope, two-sided
   */
  static RobustLine through(double[] x, double[] y, double least, double level) {
    double slope = Robust.medianSlope(x, y, 0);
    double[] rest = new double[x.length];
    Arrays.setAll(rest, i -> y[i] - slope * x[i]);
    double offset = Robust.median(rest);
    double[] off = new double[x.length];
    Arrays.setAll(off, i -> Math.abs(rest[i] - offset));
    double floor = least * Math.min(1, Math.abs(slope)) + ROUNDED_M;
    double limit = OUTLYING * Math.max(Robust.NORMAL_OVER_MAD * Robust.median(off), floor);
    int on = 0;
    double[] onX = new double[x.length];
    double[] onY = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      if (off[i] <= limit) {
        onX[on] = x[i];
        onY[on++] = y[i];
      }
    }
    return leastSquares(
        Arrays.copyOf(onX, on), Arrays.copyOf(onY, on), (double) on / x.length, floor, level);
  }

  private static RobustLine leastSquares(
      double[] x, double[] y, double share, double least, double level) {
    int n = x.length;
    double meanX = Arrays.stream(x).average().orElse(0);
    double meanY = Arrays.stream(y).average().orElse(0);
    double xx = 0;
    double xy = 0;
    for (int i = 0; i < n; i++) {
      xx += (x[i] - meanX) * (x[i] - meanX);
      xy += (x[i] - meanX) * (y[i] - meanY);
    }
    if (n < LEAST_POINTS || xx == 0) {
      return new RobustLine(Double.NaN, Double.NaN, Double.POSITIVE_INFINITY, 0);
    }
    double slope = xy / xx;
    double offset = meanY - slope * meanX;
    double squares = 0;
    for (int i = 0; i < n; i++) {
      double off = y[i] - offset - slope * x[i];
      squares += off * off;
    }
    double deviation = Math.max(Math.sqrt(squares / (n - 2)), least);
    double half =
        new TDistribution(n - 2).inverseCumulativeProbability(1 - level / 2)
            * deviation
            / Math.sqrt(xx);
    return new RobustLine(slope, offset, half, share);
  }
}
