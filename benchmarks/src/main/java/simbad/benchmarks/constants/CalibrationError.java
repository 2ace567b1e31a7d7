package simbad.benchmarks.constants;

import java.util.Arrays;
import java.util.Comparator;

/** How far probabilities are off what happens: the mean over bins of equal numbers of cases. */
final class CalibrationError {
  private static final int BINS = 10;

  private CalibrationError() {}

  /**
   * Returns it, in [0, 1]; 0 where there is no case.
   *
   * @param said a probability for each case
   * @param happened whether it came so
   */
  static double of(double[] said, boolean[] happened) {
    Integer[] order = new Integer[said.length];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, Comparator.comparingDouble(i -> said[i]));
    double error = 0;
    for (int bin = 0; bin < BINS; bin++) {
      double off = 0;
      for (int i = bin * order.length / BINS; i < (bin + 1) * order.length / BINS; i++) {
        off += said[order[i]] - (happened[order[i]] ? 1 : 0);
      }
      error += Math.abs(off);
    }
    return error / Math.max(1, order.length);
  }
}
