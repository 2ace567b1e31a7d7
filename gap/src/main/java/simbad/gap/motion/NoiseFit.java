package simbad.gap.motion;

import java.util.Arrays;

/** Finds how residuals scatter: the noise that makes them likeliest, by steps in its logarithms. */
final class NoiseFit {
  private static final double[] FREEDOMS = {3, 5, 10, Noise.GAUSSIAN};
  private static final double FINEST = 0.12;
  private static final int MOST = 80;

  /** An end of what the logarithms may come to: parts that small have no effect. */
  private static final double LEAST_LOG = Math.log(1e-9);

  private final MotionSteps given;
  private final double[] loads;
  private final double[] residuals;
  private Noise best;
  private double score;
  private int tried;

  private NoiseFit(MotionSteps given, double[] loads, double[] residuals, Noise start) {
    this.given = given;
    this.loads = loads;
    this.residuals = residuals;
    best = start;
    score = Whitening.logDensity(given, loads, start, residuals);
  }

  /** Returns the noises of all components, searched afresh. */
  static Noise[] afresh(MotionSteps given, double[][] residuals) {
    Noise[] noises = new Noise[residuals.length];
    Arrays.setAll(noises, c -> afresh(given, given.loads(), residuals[c]).best);
    return noises;
  }

  private static NoiseFit afresh(MotionSteps given, double[] loads, double[] residuals) {
    NoiseFit fit = new NoiseFit(given, loads, residuals, Noise.start(typical(residuals)));
    fit.walk(1.5);
    fit.shapes();
    fit.walk(0.25);
    return fit;
  }

  /**
   * Returns the log density of one component under the noise that makes it likeliest.
   *
   * @param given the steps
   * @param loads what the robot's own variance is in proportion to
   * @param residuals by step
   */
  static double likeliest(MotionSteps given, double[] loads, double[] residuals) {
    return afresh(given, loads, residuals).score;
  }

  /** Returns the noises of all components, from ones that were nearly right. */
  static Noise[] near(MotionSteps given, double[][] residuals, Noise[] before) {
    Noise[] noises = new Noise[residuals.length];
    Arrays.setAll(
        noises,
        c -> {
          NoiseFit fit = new NoiseFit(given, given.loads(), residuals[c], before[c]);
          fit.walk(0.3);
          return fit.best;
        });
    return noises;
  }

  /** The median size, so that what is far out counts little. */
  private static double typical(double[] residuals) {
    double[] sizes = Arrays.stream(residuals).map(Math::abs).sorted().toArray();
    return sizes.length == 0 ? 1 : sizes[sizes.length / 2];
  }

  /** Tries each logarithm up and down; steps are halved where none helps. */
  private void walk(double first) {
    tried = 0;
    for (double step = first; step > FINEST && tried < MOST; ) {
      boolean moved = false;
      for (int i = 0; i < 2; i++) {
        moved |= moved(i, step) || moved(i, -step);
      }
      step = moved ? step : step / 2;
    }
  }

  private boolean moved(int which, double by) {
    double[] logs = best.logs();
    logs[which] = Math.max(LEAST_LOG, logs[which] + by);
    return taken(best.withLogs(logs));
  }

  private void shapes() {
    for (double freedom : FREEDOMS) {
      taken(best.withFreedom(freedom));
    }
  }

  private boolean taken(Noise noise) {
    tried++;
    double now = Whitening.logDensity(given, loads, noise, residuals);
    if (now > score + 1e-6) {
      best = noise;
      score = now;
      return true;
    }
    return false;
  }
}
