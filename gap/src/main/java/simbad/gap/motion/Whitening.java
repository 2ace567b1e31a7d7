package simbad.gap.motion;

import org.hipparchus.special.Gamma;

/**
 * The log density of one component's residuals, step by step, each given those before it (a Kalman
 * filter with two states: the tracker's error at the step's start and the lasting error of the
 * rate). What remains of a residual after what the past foretold, over its scale, is white; with
 * the gains held, slopes are made white by the same filter.
 *
 * <p>A residual far out counts as the robot's own slip and widens the step's variance, so that what
 * follows is not taken for its consequence.
 */
final class Whitening {
  /** Residuals over their scales, given those before. */
  final double[] white;

  /** Weights of least squares that fit Student's t. */
  final double[] weights;

  private final Evidence evidence;
  private final Noise noise;
  private final double[] scales;
  private final double[] trackerGains;
  private final double[] rateGains;
  private final double constant;
  private double logDensity;
  private double keptFor = -1;
  private double kept;

  Whitening(Evidence evidence, Noise noise, double[] residuals) {
    this.evidence = evidence;
    this.noise = noise;
    int n = residuals.length;
    white = new double[n];
    weights = new double[n];
    scales = new double[n];
    trackerGains = new double[n];
    rateGains = new double[n];
    double nu = noise.freedom();
    constant = Gamma.logGamma((nu + 1) / 2) - Gamma.logGamma(nu / 2) - Math.log(nu * Math.PI) / 2;
    filter(residuals);
  }

  private void filter(double[] residuals) {
    double tracker = noise.tracker() * noise.tracker();
    double process = noise.process() * noise.process();
    double nu = noise.freedom();
    State state = new State(tracker, noise.rate() * noise.rate());
    for (int i = 0; i < residuals.length; i++) {
      Evidence.Step step = evidence.step(i);
      if (!step.chained()) {
        state.begin();
      }
      double s = step.durationS();
      double own = process * step.load() * s;
      double withRate = state.rateVar * s - state.both;
      double variance = withRate * s - state.both * s + state.errorVar + own + tracker;
      double innovation = residuals[i] - (state.rate * s - state.error);
      double scale = Math.sqrt(variance);
      double z = innovation / scale;
      scales[i] = scale;
      white[i] = z;
      weights[i] = (nu + 1) / (nu + z * z);
      logDensity += logDensity(z, scale);
      // Given Student's t, a far residual came with a variance that was larger by so much.
      double widened = variance * Math.max(1, 1 / weights[i]);
      trackerGains[i] = tracker / widened;
      rateGains[i] = withRate / widened;
      state.advance(i, innovation, withRate, s);
    }
  }

  /** Steps are mostly of one length. */
  private double kept(double seconds) {
    if (Math.abs(seconds - keptFor) > 1e-9) {
      keptFor = seconds;
      kept = Math.exp(-seconds / noise.lastsS());
    }
    return kept;
  }

  /** Means and variances of the tracker's error and the rate's, and their covariance. */
  private final class State {
    private final double tracker;
    private final double lasting;
    private double error;
    private double rate;
    private double errorVar;
    private double rateVar;
    private double both;

    State(double tracker, double lasting) {
      this.tracker = tracker;
      this.lasting = lasting;
    }

    void begin() {
      error = 0;
      rate = 0;
      errorVar = tracker;
      rateVar = lasting;
      both = 0;
    }

    void advance(int i, double innovation, double withRate, double seconds) {
      double kept = kept(seconds);
      error = trackerGains[i] * innovation;
      rate = kept * (rate + rateGains[i] * innovation);
      errorVar = tracker * (1 - trackerGains[i]);
      rateVar = kept * kept * (rateVar - rateGains[i] * withRate) + lasting * (1 - kept * kept);
      both = -kept * rateGains[i] * tracker;
    }
  }

  double logDensity(double z, double scale) {
    double nu = noise.freedom();
    return constant - (nu + 1) / 2 * Math.log1p(z * z / nu) - Math.log(scale);
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
    double rate = 0;
    for (int i = 0; i < column.length; i++) {
      Evidence.Step step = evidence.step(i);
      if (!step.chained()) {
        error = 0;
        rate = 0;
      }
      double s = step.durationS();
      double innovation = column[i] - (rate * s - error);
      result[i] = innovation / scales[i];
      error = trackerGains[i] * innovation;
      rate = kept(s) * (rate + rateGains[i] * innovation);
    }
    return result;
  }
}
