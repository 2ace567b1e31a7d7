package simbad.gap.motion;

import org.hipparchus.special.Erf;

/** What a deviation in standard errors says. */
final class Chance {
  /** Of a normal deviate 95 % are no further than this. */
  static final double NORMAL_95 = 1.96;

  /** Nothing that is measured is certain. */
  private static final double MOST = 1 - 1e-6;

  private Chance() {}

  /** Returns how probable it is that a normal deviate is less. */
  static double below(double deviations) {
    return Math.min(MOST, Erf.erfc(-deviations / Math.sqrt(2)) / 2);
  }

  /**
   * Returns how sure something is that was chosen among several for its deviation (Bonferroni).
   *
   * @param deviations of the one that was chosen
   * @param among how many, at least 1
   * @return in [0, 1]
   */
  static double chosen(double deviations, int among) {
    return Math.max(0, 1 - among * (1 - below(deviations)));
  }
}
