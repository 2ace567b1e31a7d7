package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * Some echoes arrive by a longer way, short detours more often than long ones: what they are longer
 * by is exponentially distributed, here in slices that are Gaussian with the slice's own mean and
 * deviation. After the sensor's time is over they are lost.
 *
 * @param share of the echoes, in [0, 1]; 0 is neutral
 * @param meanExtraM mean of what the way is longer by, metres
 */
public record TailedMultipath(double share, double meanExtraM) implements MixtureChange {
  private static final double[] QUANTILES = {0, 0.3, 0.65, 0.9, 1};
  private static final double[] MEAN = new double[QUANTILES.length - 1];
  private static final double[] DEVIATION = new double[QUANTILES.length - 1];

  static {
    for (int slice = 0; slice < MEAN.length; slice++) {
      double probability = QUANTILES[slice + 1] - QUANTILES[slice];
      double from = -Math.log1p(-QUANTILES[slice]);
      double to = -Math.log1p(-QUANTILES[slice + 1]);
      // Integrals of x exp(-x) and x^2 exp(-x); at infinity both are 0.
      MEAN[slice] = (first(from) - first(to)) / probability;
      double square = (second(from) - second(to)) / probability;
      DEVIATION[slice] = Math.sqrt(square - MEAN[slice] * MEAN[slice]);
    }
  }

  private static double first(double x) {
    return x == Double.POSITIVE_INFINITY ? 0 : (x + 1) * Math.exp(-x);
  }

  private static double second(double x) {
    return x == Double.POSITIVE_INFINITY ? 0 : (x * x + 2 * x + 2) * Math.exp(-x);
  }

  /** Checks the figures; NaN is refused. */
  public TailedMultipath {
    Checks.share("share", share);
    Checks.notNegative("meanExtraM", meanExtraM);
  }

  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (share == 0) {
      return;
    }
    double most = moment.geometry().sensor().maxRangeM();
    int parts = mixture.size();
    for (int part = 0; part < parts; part++) {
      for (int slice = 0; slice < MEAN.length; slice++) {
        mixture.addUpTo(
            most,
            mixture.meanM(part) + meanExtraM * MEAN[slice],
            Deviations.together(mixture.deviationM(part), meanExtraM * DEVIATION[slice]),
            share * (QUANTILES[slice + 1] - QUANTILES[slice]) * mixture.share(part));
      }
      mixture.scaleShare(part, 1 - share);
    }
  }
}
