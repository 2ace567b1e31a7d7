package simbad.experiments.blindcheck;

import simbad.experiments.blindcheck.CheckScores.Estimate;

/**
 * So many of so many, with Wilson's 95 % interval (E. B. Wilson, "Probable inference, the law of
 * succession, and statistical inference", Journal of the American Statistical Association 22, 1927,
 * 209-212).
 *
 * @param hits counted
 * @param all of so many, one or more
 */
public record WilsonShare(int hits, int all) {
  private static final double NORMAL_95 = 1.96;

  /** Refuses counts that make no share. */
  public WilsonShare {
    if (all < 1 || hits < 0 || hits > all) {
      throw new IllegalArgumentException(hits + " of " + all + ", expected a share of some");
    }
  }

  /** The share with its interval. */
  public Estimate estimate() {
    double n = all;
    double p = hits / n;
    double z2 = NORMAL_95 * NORMAL_95;
    double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
    double half = NORMAL_95 / (1 + z2 / n) * Math.sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    return new Estimate(
        p, Math.max(0, middle - half), Math.min(1, middle + half), hits + " of " + all);
  }
}
