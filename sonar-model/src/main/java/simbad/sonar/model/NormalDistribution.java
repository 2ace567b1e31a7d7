package simbad.sonar.model;

/**
 * The standard normal distribution function, to about 1e-15.
 *
 * <p>Central part: Marsaglia (2004), "Evaluating the Normal Distribution", Journal of Statistical
 * Software 11(4), the Taylor series. Tail: the continued fraction of Mills' ratio (Abramowitz and
 * Stegun 1964, 26.2.14). Written here because this room may use no numerics library.
 */
public final class NormalDistribution {
  private static final double TAIL = 5;

  /** Beyond these the result is rounded to 1 and 0 anyhow. */
  private static final double ONE_BEYOND = 9;

  private static final double ZERO_BEYOND = 39;
  private static final int TAIL_TERMS = 60;
  private static final double LOG_ROOT_2_PI = 0.5 * Math.log(2 * Math.PI);

  private NormalDistribution() {}

  /**
   * Probability of a value up to x.
   *
   * @param x any number, infinities included; of NaN it is NaN
   */
  public static double cumulative(double x) {
    if (x > ONE_BEYOND) {
      return 1;
    }
    if (x < -TAIL) {
      return x < -ZERO_BEYOND ? 0 : tail(-x);
    }
    return x > TAIL ? 1 - tail(x) : 0.5 + series(x);
  }

  private static double density(double x) {
    return Math.exp(-0.5 * x * x - LOG_ROOT_2_PI);
  }

  private static double series(double x) {
    double sum = x;
    double term = x;
    double previous = 0;
    for (int i = 3; Math.abs(sum - previous) > 0; i += 2) {
      previous = sum;
      term *= x * x / i;
      sum += term;
    }
    return sum * density(x);
  }

  private static double tail(double x) {
    if (x == Double.POSITIVE_INFINITY) {
      return 0;
    }
    double fraction = x;
    for (int i = TAIL_TERMS; i >= 1; i--) {
      fraction = x + i / fraction;
    }
    return density(x) / fraction;
  }
}
