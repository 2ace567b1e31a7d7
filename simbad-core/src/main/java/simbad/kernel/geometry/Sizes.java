package simbad.kernel.geometry;

/** Checks of sizes, written so that NaN fails. */
final class Sizes {
  private Sizes() {}

  static void requireAtLeastZero(String name, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " = " + value + " is not in [0, infinity)");
    }
  }
}
