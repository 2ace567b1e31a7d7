package simbad.sonar.model;

import java.util.random.RandomGenerator;

/**
 * The standard normal distribution: its distribution function, to about 1e-15, and its numbers.
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

  // Ratio of uniforms (Kinderman and Monahan 1977) with the quadratic bounds of J. L. Leva, "A fast
  // normal random number generator", ACM Transactions on Mathematical Software 18(4), 1992,
  // 449-453.
  private static final double RATIO_HEIGHT = 1.7156;
  private static final double RATIO_U = 0.449871;
  private static final double RATIO_V = -0.386595;
  private static final double RATIO_A = 0.196;
  private static final double RATIO_B = 0.25472;
  private static final double RATIO_INNER = 0.27597;
  private static final double RATIO_OUTER = 0.27846;

  private NormalDistribution() {}

  /**
   * Draws a number. It depends on nothing but uniform numbers, while those of {@link
   * RandomGenerator#nextGaussian} are not the same in every version of Java.
   *
   * @param random chance; two uniform numbers of it are used at a time, 1.37 times on average
   */
  public static double draw(RandomGenerator random) {
    while (true) {
      double u = 1 - random.nextDouble();
      double v = RATIO_HEIGHT * (random.nextDouble() - 0.5);
      double x = u - RATIO_U;
      double y = Math.abs(v) - RATIO_V;
      double q = x * x + y * (RATIO_A * y - RATIO_B * x);
      if (q < RATIO_INNER || (q <= RATIO_OUTER && v * v <= -4 * u * u * StrictMath.log(u))) {
        return v / u;
      }
    }
  }

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
