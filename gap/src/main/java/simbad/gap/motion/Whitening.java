package simbad.gap.motion;

import org.hipparchus.special.Gamma;

/**
 * The log density of one component's residuals, step by step, each given those before it (a Kalman
 * filter with one state: the tracker's error at the step's start). What remains of a residual after
 * what the past foretold, over its scale, is white; with the gains held, slopes are made white by
 * the same filter.
 *
 * <p>A residual far out counts as the robot's own slip and widens the step's variance, so that what
 * follows is not taken for its consequence.
 */
final class Whitening {
  /** Residuals over their scales, given those before. */
  final double[] white;

  /** Weights of least squares that fit Student's t. */
  final double[] weights;

  private final MotionSteps given;
  private final Noise noise;
  private final double[] scales;
  private final double[] gains;
  private final double constant;
  private double logDensity;

  Whitening(MotionSteps given, Noise noise, double[] residuals) {
    this(given, given.loads(), noise, residuals);
  }

  /**
   * Filters.
   *
   * @param given the steps
   * @param loads what the robot's own variance is in proportion to, by step
   * @param noise by which the residuals scatter
   * @param residuals by step
   */
  Whitening(MotionSteps given, double[] loads, Noise noise, double[] residuals) {
    this(given, loads, noise, residuals, true);
  }

  private Whitening(
      MotionSteps given, double[] loads, Noise noise, double[] residuals, boolean kept) {
    this.given = given;
    this.noise = noise;
    int n = kept ? residuals.length : 0;
    white = new double[n];
    weights = new double[n];
    scales = new double[n];
    gains = new double[n];
    double nu = noise.freedom();
    constant = Gamma.logGamma((nu + 1) / 2) - Gamma.logGamma(nu / 2) - Math.log(nu * Math.PI) / 2;
    filter(loads, residuals);
  }

  private void filter(double[] loads, double[] residuals) {
    double tracker = noise.tracker() * noise.tracker();
    double process = noise.process() * noise.process();
    double nu = noise.freedom();
    double perWeight = 1 / (nu + 1);
    double error = 0;
    double errorVar = tracker;
    LogProduct sizes = new LogProduct();
    LogProduct variances = new LogProduct();
    for (int i = 0; i < residuals.length; i++) {
      if (!given.isChained(i)) {
        error = 0;
        errorVar = tracker;
      }
      double variance = errorVar + process * loads[i] * given.durationS(i) + tracker;
      double innovation = residuals[i] + error;
      double square = innovation * innovation;
      sizes.times(1 + square / (nu * variance));
      variances.times(variance);
      // Given Student's t, a far residual came with a variance that was larger by so much.
      double gain = tracker / Math.max(variance, (nu * variance + square) * perWeight);
      error = gain * innovation;
      errorVar = tracker * (1 - gain);
      if (i < gains.length) {
        gains[i] = gain;
        scales[i] = Math.sqrt(variance);
        white[i] = innovation / scales[i];
        weights[i] = (nu + 1) * variance / (nu * variance + square);
      }
    }
    logDensity = residuals.length * constant - (nu + 1) / 2 * sizes.log() - variances.log() / 2;
  }

  double logDensity(double z, double scale) {
    double nu = noise.freedom();
    return constant - (nu + 1) / 2 * Math.log1p(z * z / nu) - Math.log(scale);
  }

  /** Returns the log density of the residuals of all components, each under its noise. */
  static double logDensity(MotionSteps given, Noise[] noises, double[][] residuals) {
    double sum = 0;
    for (int c = 0; c < residuals.length; c++) {
      sum += logDensity(given, given.loads(), noises[c], residuals[c]);
    }
    return sum;
  }

  /**
   * Returns the log density of the residuals of one component.
   *
   * @param given the steps
   * @param loads what the robot's own variance is in proportion to, by step
   * @param noise by which the residuals scatter
   * @param residuals by step
   */
  static double logDensity(MotionSteps given, double[] loads, Noise noise, double[] residuals) {
    return new Whitening(given, loads, noise, residuals, false).logDensity;
  }

  /** Returns the sum of the log densities of all steps. */
  double logDensity() {
    return logDensity;
  }

  /** Returns the log density of a step were its white residual another. */
  double logDensity(int step, double z) {
    return logDensity(z, scales[step]);
  }

  /**
   * Returns what a residual tells of its mean, over its weight: (nu + 1) / (nu + 3) for Student's t
   * (Lange, Little and Taylor 1989). Weights alone would say too much, as if far residuals were
   * known to be far whatever the mean is.
   */
  double information() {
    return (noise.freedom() + 1) / (noise.freedom() + 3);
  }

  /** Makes a column of slopes white by the same filter, its gains as they are. */
  double[] of(double[] column) {
    double[] result = new double[column.length];
    double error = 0;
    for (int i = 0; i < column.length; i++) {
      double innovation = column[i] + (given.isChained(i) ? error : 0);
      result[i] = innovation / scales[i];
      error = gains[i] * innovation;
    }
    return result;
  }
}
