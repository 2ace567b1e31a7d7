package simbad.gap.audit;

import org.hipparchus.special.Beta;

/** Exact tests of counts. */
final class Tail {
  /** All checks of all clean data sets together are wrong in less than one of a hundred. */
  private static final double FALSE_ALARMS = 0.01;

  /** What one check may be wrong in. */
  static final double LEVEL = FALSE_ALARMS / AuditCheck.ofReadings();

  private Tail() {}

  /**
   * The chance of at least so many hits of independent trials (the binomial's upper tail, as the
   * regularized incomplete beta function: Abramowitz and Stegun 1964, 26.5.24).
   *
   * @param hits in [0, trials]
   * @param trials at least 0
   * @param chance of each, in [0, 1]
   */
  static double atLeast(int hits, int trials, double chance) {
    if (hits <= 0) {
      return 1;
    }
    if (chance <= 0 || chance >= 1) {
      return chance <= 0 ? 0 : 1;
    }
    return Beta.regularizedBeta(chance, hits, trials - hits + 1.0);
  }
}
