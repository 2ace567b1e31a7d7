package simbad.scattering;

/**
 * The Hankel functions of the first kind of order 0 and 1, H = J + i Y, for positive arguments.
 *
 * <p>Up to {@value #SERIES_UP_TO} from the ascending series (DLMF 10.2.2, 10.8.1), above it from
 * Hankel's asymptotic expansion (DLMF 10.17.5), broken off at its smallest term. Absolute error
 * below 1e-10 everywhere, relative to |H|.
 *
 * @param j0 J of order 0
 * @param y0 Y of order 0
 * @param j1 J of order 1
 * @param y1 Y of order 1
 */
record Hankel(double j0, double y0, double j1, double y1) {
  private static final double SERIES_UP_TO = 12;
  private static final double EULER_GAMMA = 0.5772156649015329;
  private static final double NEGLIGIBLE = 1e-17;
  private static final int SERIES_TERMS = 48;
  private static final double[][] SERIES = seriesTerms();
  private static final int ASYMPTOTIC_TERMS = 24;
  private static final double[] ASYMPTOTIC_0 = asymptoticTerms(0);
  private static final double[] ASYMPTOTIC_1 = asymptoticTerms(4);

  /**
   * Computes all four.
   *
   * @param x positive, finite
   * @throws IllegalArgumentException if it is not
   */
  static Hankel at(double x) {
    if (!(x > 0 && x < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("x = " + x + " is not in (0, infinity)");
    }
    return x <= SERIES_UP_TO ? series(x) : asymptotic(x);
  }

  private static Hankel series(double x) {
    double q = -x * x / 4;
    double power = 1;
    double j0 = 1;
    double j1 = 1;
    double sum0 = 0;
    double sum1 = 1;
    double size = 1;
    for (int m = 1; size > NEGLIGIBLE && m < SERIES.length; m++) {
      double[] term = SERIES[m];
      power *= q;
      j0 += power * term[0];
      sum0 += power * term[1];
      j1 += power * term[2];
      sum1 += power * term[3];
      size = Math.abs(power) * term[1];
    }
    double log = Math.log(x / 2) + EULER_GAMMA;
    j1 *= x / 2;
    double y0 = 2 / Math.PI * (log * j0 - sum0);
    double y1 = 2 / Math.PI * (log * j1 - 1 / x - x / 4 * sum1);
    return new Hankel(j0, y0, j1, y1);
  }

  /** What stands by (-x^2/4)^m in J0, in the sum of Y0, in J1 less x/2, and in the sum of Y1. */
  private static double[][] seriesTerms() {
    double[][] terms = new double[SERIES_TERMS][];
    double even = 1; // 1 / m!^2
    double harmonic = 0; // 1 + 1/2 + ... + 1/m
    for (int m = 0; m < SERIES_TERMS; m++) {
      if (m > 0) {
        even /= (double) m * m;
        harmonic += 1.0 / m;
      }
      double odd = even / (m + 1);
      terms[m] = new double[] {even, harmonic * even, odd, (2 * harmonic + 1.0 / (m + 1)) * odd};
    }
    return terms;
  }

  private static Hankel asymptotic(double x) {
    double size = Math.sqrt(2 / (Math.PI * x));
    double cos = size * Math.cos(x - Math.PI / 4);
    double sin = size * Math.sin(x - Math.PI / 4);
    double[] zero = asymptoticSum(x, ASYMPTOTIC_0);
    double[] one = asymptoticSum(x, ASYMPTOTIC_1);
    // A quarter of a turn later: cos(a - pi/2) = sin a, sin(a - pi/2) = -cos a.
    return new Hankel(
        zero[0] * cos - zero[1] * sin,
        zero[0] * sin + zero[1] * cos,
        one[0] * sin + one[1] * cos,
        one[1] * sin - one[0] * cos);
  }

  /** Real and imaginary part of the sum of i^k a_k / x^k, up to its smallest term. */
  private static double[] asymptoticSum(double x, double[] a) {
    double[] sum = {1, 0};
    double power = 1;
    double last = 1;
    for (int k = 1; k < a.length; k++) {
      power /= x;
      double term = a[k] * power;
      double size = Math.abs(term);
      if (size >= last || size < NEGLIGIBLE) {
        break;
      }
      last = size;
      sum[k % 2] += k % 4 < 2 ? term : -term;
    }
    return sum;
  }

  /** The a_k of DLMF 10.17.1; mu is 4 times the order squared. */
  private static double[] asymptoticTerms(double mu) {
    double[] a = new double[ASYMPTOTIC_TERMS];
    a[0] = 1;
    for (int k = 1; k < a.length; k++) {
      double odd = 2 * k - 1;
      a[k] = a[k - 1] * (mu - odd * odd) / (8 * k);
    }
    return a;
  }
}
