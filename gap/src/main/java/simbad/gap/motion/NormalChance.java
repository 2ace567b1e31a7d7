package simbad.gap.motion;

import org.hipparchus.special.Erf;

/** What a deviation in standard errors says, and odds. */
final class NormalChance {
  /** Of a normal deviate 95 % are no further than this. */
  static final double NORMAL_95 = 1.96;

  /** The median size of a standard normal deviate. */
  static final double MEDIAN = 0.6745;

  /** Nothing that is measured is certain. */
  private static final double MOST = 1 - 1e-6;

  private NormalChance() {}

  /** Returns how probable it is that a normal deviate is less. */
  static double below(double deviations) {
    return Math.min(MOST, Erf.erfc(-deviations / Math.sqrt(2)) / 2);
  }

  /** Returns the normal deviate that a share of all are below. */
  static double deviate(double share) {
    return Math.sqrt(2) * Erf.erfInv(2 * share - 1);
  }

  /** Returns the probability that has these log odds. */
  static double ofLogOdds(double nats) {
    return Math.min(MOST, 1 / (1 + Math.exp(-nats)));
  }
}
