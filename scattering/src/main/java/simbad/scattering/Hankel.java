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
  private static final int ASYMPTOTIC_TERMS = 24;

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
    double term = 1; // (-x^2/4)^m / m!^2
    double harmonic = 0; // 1 + 1/2 + ... + 1/m
    double j0 = 1;
    double j1 = 1;
    double sum0 = 0;
    double sum1 = 1;
    for (int m = 1; Math.abs(term) > NEGLIGIBLE || m < x; m++) {
      term *= q / ((double) m * m);
      harmonic += 1.0 / m;
      j0 += term;
      sum0 += harmonic * term;
      double odd = term / (m + 1);
      j1 += odd;
      sum1 += (2 * harmonic + 1.0 / (m + 1)) * odd;
    }
    double log = Math.log(x / 2) + EULER_GAMMA;
    j1 *= x / 2;
    double y0 = 2 / Math.PI * (log * j0 - sum0);
    double y1 = 2 / Math.PI * (log * j1 - 1 / x - x / 4 * sum1);
    return new Hankel(j0, y0, j1, y1);
  }

  private static Hankel asymptotic(double x) {
    double size = Math.sqrt(2 / (Math.PI * x));
    double phase = x - Math.PI / 4;
    double[] zero = rotated(x, 0, size, phase);
    double[] one = rotated(x, 4, size, phase - Math.PI / 2);
    return new Hankel(zero[0], zero[1], one[0], one[1]);
  }

  /** Sum of i^k a_k / x^k, times size e^(i phase); mu is 4 times the order squared. */
  private static double[] rotated(double x, double mu, double size, double phase) {
    double re = 1;
    double im = 0;
    double term = 1;
    for (int k = 1; k < ASYMPTOTIC_TERMS; k++) {
      double odd = 2 * k - 1;
      double next = term * (mu - odd * odd) / (8 * k * x);
      if (Math.abs(next) >= Math.abs(term)) {
        break;
      }
      term = next;
      switch (k % 4) {
        case 1 -> im += term;
        case 2 -> re -= term;
        case 3 -> im -= term;
        default -> re += term;
      }
    }
    double cos = Math.cos(phase);
    double sin = Math.sin(phase);
    return new double[] {size * (re * cos - im * sin), size * (re * sin + im * cos)};
  }
}
