package simbad.gap.calibrate.level;

import java.util.List;
import org.hipparchus.special.Erf;

/** The chance of an echo by its excess: misses, strangers, and what lies between. */
final class Misses {
  /** Nothing is certain: what no strength explains must not decide a fit. */
  private static final double STRANGE = 0.002;

  /** So many trials the believed rate is worth. */
  private static final double BELIEVED = 50;

  private static final double ROOT_2_PI = Math.sqrt(2 * Math.PI);

  private final double believed;
  private double rate;

  Misses(double missRate) {
    believed = missRate;
    rate = missRate;
  }

  /**
   * Returns the chance of an echo.
   *
   * @param deviations by which it is over the threshold
   * @param share what effects leave of it
   */
  double chance(double deviations, double share) {
    return STRANGE + share * (1 - rate) * (1 - 2 * STRANGE) * normal(deviations);
  }

  /** Returns how fast the chance rises with the deviations. */
  double slope(double deviations, double share) {
    double density = Math.exp(-deviations * deviations / 2) / ROOT_2_PI;
    return share * (1 - rate) * (1 - 2 * STRANGE) * density;
  }

  private static double normal(double deviations) {
    return deviations < -12 ? 0 : Erf.erfc(-deviations / Math.sqrt(2)) / 2;
  }

  /** Counts what was missed though it was strong enough, as far as that is known. */
  void update(Predictor predictor, List<Predictor.Row> trials) {
    double missed = BELIEVED * believed;
    double tried = BELIEVED;
    for (Predictor.Row row : trials) {
      double strong = row.trial().share() * normal(predictor.excess(row).inDeviations());
      if (row.trial().isRead()) {
        tried++;
      } else {
        double silent = 1 - (1 - rate) * strong;
        double own = silent > 0 ? rate * strong / silent : 0;
        // What no strength explains is no miss of the law's either.
        double share = own * silent / (silent + STRANGE);
        missed += share;
        tried += share;
      }
    }
    rate = missed / tried;
  }

  double rate() {
    return rate;
  }
}
