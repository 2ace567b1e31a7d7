package simbad.sonar.ping;

import simbad.sonar.model.NormalDistribution;

/**
 * The standard normal distribution function from a table, to 1e-11: a fit asks it a hundred million
 * times, and a share of the outcomes a million times greater is given to what no model explains.
 */
public final class QuickNormal {
  private static final double REACH = 8;
  private static final int PER_UNIT = 128;
  private static final double STEP = 1.0 / PER_UNIT;
  private static final double[] VALUE = new double[(int) (2 * REACH * PER_UNIT) + 2];
  private static final double[] SLOPE = new double[VALUE.length];

  static {
    for (int i = 0; i < VALUE.length; i++) {
      double x = i * STEP - REACH;
      VALUE[i] = NormalDistribution.cumulative(x);
      SLOPE[i] = Math.exp(-0.5 * x * x) / Math.sqrt(2 * Math.PI) * STEP;
    }
  }

  private QuickNormal() {}

  /** Probability of a value up to x; by Hermite's cubic between the table's points. */
  public static double cumulative(double x) {
    if (x <= -REACH) {
      return 0;
    }
    if (x >= REACH) {
      return 1;
    }
    double place = (x + REACH) * PER_UNIT;
    int i = (int) place;
    double t = place - i;
    double u = 1 - t;
    return u * u * ((1 + 2 * t) * VALUE[i] + t * SLOPE[i])
        + t * t * ((1 + 2 * u) * VALUE[i + 1] - u * SLOPE[i + 1]);
  }

  /**
   * Returns how probable it is that a normal deviate is no more than so much above its mean.
   *
   * @param more above the mean; may be negative
   * @param deviation its standard deviation; where it is not above 0, it is its mean
   */
  public static double atMost(double more, double deviation) {
    return deviation > 0 ? cumulative(more / deviation) : more >= 0 ? 1 : 0;
  }
}
