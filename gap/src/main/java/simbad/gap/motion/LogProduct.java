package simbad.gap.motion;

/** The logarithm of a product of many numbers: one logarithm for as many as a double holds. */
final class LogProduct {
  private static final double MOST = 1e100;
  private static final double LEAST = 1e-100;

  private double product = 1;
  private double log;

  /**
   * Multiplies.
   *
   * @param factor above 0; within 1e-200 and 1e200 nothing is lost
   */
  void times(double factor) {
    product *= factor;
    if (!(product > LEAST && product < MOST)) {
      log += Math.log(product);
      product = 1;
    }
  }

  /** Returns the logarithm of the product of all factors so far, 0 without any. */
  double log() {
    return log + Math.log(product);
  }
}
