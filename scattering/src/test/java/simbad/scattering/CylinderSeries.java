package simbad.scattering;

/**
 * The exact echo of a rigid cylinder: the sum over partial waves (Morse and Ingard 1968, section
 * 8.1), |f| = sqrt(2 / (pi k)) |sum of e_n (-1)^n J_n'(ka) / H_n'(ka)|.
 */
final class CylinderSeries {
  private static final int BEYOND = 20;

  private CylinderSeries() {}

  static double backscatter(double wavenumber, double radiusM) {
    double x = wavenumber * radiusM;
    int last = (int) x + BEYOND;
    double[] j = besselJ(x, last + 1);
    double[] y = besselY(x, last + 1);
    double re = 0;
    double im = 0;
    for (int n = 0; n <= last; n++) {
      double jSlope = slope(j, n, x);
      double ySlope = slope(y, n, x);
      double sign = (n == 0 ? 1 : 2) * (n % 2 == 0 ? 1 : -1);
      double power = jSlope * jSlope + ySlope * ySlope;
      re += sign * jSlope * jSlope / power;
      im -= sign * jSlope * ySlope / power;
    }
    return Math.sqrt(2 / (Math.PI * wavenumber)) * Math.hypot(re, im);
  }

  private static double slope(double[] b, int n, double x) {
    return n == 0 ? -b[1] : b[n - 1] - n / x * b[n];
  }

  /** Downward recurrence, which is stable for J, scaled by the sum J_0 + 2 J_2 + 2 J_4 ... = 1. */
  static double[] besselJ(double x, int last) {
    int start = 2 * ((last + 40) / 2);
    double[] t = new double[start + 2];
    t[start] = 1e-250;
    double sum = 2 * t[start];
    for (int n = start; n > 0; n--) {
      t[n - 1] = 2 * n / x * t[n] - t[n + 1];
      sum += (n - 1) % 2 == 0 ? (n == 1 ? 1 : 2) * t[n - 1] : 0;
    }
    double[] j = new double[last + 1];
    for (int n = 0; n <= last; n++) {
      j[n] = t[n] / sum;
    }
    return j;
  }

  /** Upward recurrence, which is stable for Y. */
  private static double[] besselY(double x, int last) {
    Hankel h = Hankel.at(x);
    double[] y = new double[last + 1];
    y[0] = h.y0();
    y[1] = h.y1();
    for (int n = 1; n < last; n++) {
      y[n + 1] = 2 * n / x * y[n] - y[n - 1];
    }
    return y;
  }
}
