package simbad.blindworld.wave;

/** The directivity of a round piston in a baffle, 2 J1(x) / x with x = k a sin(angle). */
final class Piston {

  private static final int STEPS = 1024;

  private final double[] bySine = new double[STEPS + 2];

  /** A piston of a radius at a wave number, in metres and radians per metre. */
  Piston(double radiusM, double wavePerM) {
    for (int i = 0; i < bySine.length; i++) {
      bySine[i] = directivity(wavePerM * radiusM * i / STEPS);
    }
  }

  /**
   * 2 J1(x) / x by its power series, 1 at x = 0. Good to ten digits up to x = 15, which is three
   * times what a ranger's piston has.
   */
  static double directivity(double x) {
    double quarter = -x * x / 4;
    double term = 1;
    double sum = 1;
    for (int n = 1; n < 60; n++) {
      term *= quarter / (n * (n + 1.0));
      sum += term;
    }
    return sum;
  }

  /** The directivity at an angle with the sine, in [0, 1]. */
  double at(double sine) {
    double place = Math.min(1, Math.abs(sine)) * STEPS;
    int i = (int) place;
    return bySine[i] + (place - i) * (bySine[i + 1] - bySine[i]);
  }
}
