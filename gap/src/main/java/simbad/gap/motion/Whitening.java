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
    this.given = given;
    this.noise = noise;
    int n = residuals.length;
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
    double error = 0;
    double errorVar = tracker;
    for (int i = 0; i < residuals.length; i++) {
      MotionSteps.Step step = given.step(i);
      if (!step.chained()) {
        error = 0;
        errorVar = tracker;
      }
      double variance = errorVar + process * loads[i] * step.durationS() + tracker;
      double innovation = residuals[i] + error;
      double scale = Math.sqrt(variance);
      double z = innovation / scale;
      scales[i] = scale;
      white[i] = z;
      weights[i] = (nu + 1) / (nu + z * z);
      logDensity += logDensity(z, scale);
      // Given Student's t, a far residual came with a variance that was larger by so much.
      gains[i] = tracker / (variance * Math.max(1, 1 / weights[i]));
      error = gains[i] * innovation;
      errorVar = tracker * (1 - gains[i]);
    }
  }

  double logDensity(double z, double scale) {
    double nu = noise.freedom();
    return constant - (nu + 1) / 2 * Math.log1p(z * z / nu) - Math.log(scale);
  }

  /** Returns the log density of the residuals of all components, each under its noise. */
  static double logDensity(MotionSteps given, Noise[] noises, double[][] residuals) {
    double sum = 0;
    for (int c = 0; c < residuals.length; c++) {
      sum += new Whitening(given, noises[c], residuals[c]).logDensity();
    }
    return sum;
  }

  /** Returns the sum of the log densities of all steps. */
  double logDensity() {
    return logDensity;
  }

  /** Returns the log density of a step were its white residual another. */
  double logDensity(int step, double z) {
    return logDensity(z, scales[step]);
  }

  /** Makes a column of slopes white by the same filter, its gains as they are. */
  double[] of(double[] column) {
    double[] result = new double[column.length];
    double error = 0;
    for (int i = 0; i < column.length; i++) {
      double innovation = column[i] + (given.step(i).chained() ? error : 0);
      result[i] = innovation / scales[i];
      error = gains[i] * innovation;
    }
    return result;
  }
}
