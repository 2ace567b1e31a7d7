package simbad.gap.explain;

import org.hipparchus.special.Erf;

/** Quantiles of the standard normal distribution. */
final class NormalQuantile {
  private NormalQuantile() {}

  /** Returns the value that a share of the distribution lies below; share in (0, 1). */
  static double of(double share) {
    return -Math.sqrt(2) * Erf.erfcInv(2 * share);
  }

  /** Returns the probability of a value further from 0 than x, either way. */
  static double twoSided(double x) {
    return Erf.erfc(Math.abs(x) / Math.sqrt(2));
  }
}
