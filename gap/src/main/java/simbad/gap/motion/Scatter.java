package simbad.gap.motion;

import java.util.Arrays;

/**
 * How displacements scatter about what a model expects: each component by Student's t with four
 * degrees of freedom, so that a slip counts as one and bends no fit.
 *
 * @param scales of along, across (m) and turn (rad); above 0
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record Scatter(double[] scales) {
  static final double FREEDOM = 4;

  /** The median size of Student's t with four degrees of freedom. */
  private static final double MEDIAN = 0.7407;

  /** log of the density's constant: gamma(5/2) / (gamma(2) sqrt(4 pi)) = 3/8. */
  private static final double LOG_CONSTANT = Math.log(0.375);

  /** A track is never known better than this: files have so many digits. */
  private static final double[] LEAST = {5e-5, 5e-5, 5e-5};

  /** Estimates the scales from residuals of the windows that a mask lets through. */
  static Scatter of(double[][] residuals, boolean[] mask) {
    double[] scales = new double[3];
    for (int c = 0; c < 3; c++) {
      double[] sizes = new double[residuals.length];
      int n = 0;
      for (int i = 0; i < residuals.length; i++) {
        if (mask[i]) {
          sizes[n++] = Math.abs(residuals[i][c]);
        }
      }
      scales[c] = Math.max(LEAST[c], n == 0 ? 1 : median(Arrays.copyOf(sizes, n)) / MEDIAN);
    }
    return new Scatter(scales);
  }

  private static double median(double[] values) {
    Arrays.sort(values);
    return values[values.length / 2];
  }

  /** Returns the log density of a window's residuals. */
  double logDensity(double[] residual) {
    double sum = 0;
    for (int c = 0; c < 3; c++) {
      double r = residual[c] / scales[c];
      sum += LOG_CONSTANT - Math.log(scales[c]) - (FREEDOM + 1) / 2 * Math.log1p(r * r / FREEDOM);
    }
    return sum;
  }

  /** Returns the weight that least squares must give a component to fit Student's t. */
  double weight(double[] residual, int component) {
    double r = residual[component] / scales[component];
    return (FREEDOM + 1) / (FREEDOM + r * r) / (scales[component] * scales[component]);
  }
}
