package simbad.gap.score;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Corrects for the number of tests: who looks at many places finds one in twenty by chance alone.
 *
 * <p>References: Benjamini and Hochberg, Controlling the false discovery rate, 1995.
 */
public final class BenjaminiHochberg {
  private BenjaminiHochberg() {}

  /**
   * Returns the q-values: the least false discovery rate at which each test is discovered.
   *
   * @param chance of each test, its p-value, in [0, 1]
   * @return one for each, in the same order, in [0, 1]
   */
  public static double[] falseDiscoveryRates(List<Double> chance) {
    List<Integer> order = new ArrayList<>(IntStream.range(0, chance.size()).boxed().toList());
    order.sort(Comparator.comparingDouble(chance::get));
    double[] rate = new double[chance.size()];
    double least = 1;
    for (int rank = order.size(); rank >= 1; rank--) {
      int test = order.get(rank - 1);
      least = Math.min(least, chance.get(test) * order.size() / rank);
      rate[test] = least;
    }
    return rate;
  }
}
