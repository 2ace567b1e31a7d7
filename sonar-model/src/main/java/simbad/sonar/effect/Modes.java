package simbad.sonar.effect;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.DoubleStream;

/** Where values crowd. */
public final class Modes {
  private Modes() {}

  /**
   * Finds the middles of the fullest windows of a width.
   *
   * @param values any number
   * @param width of a window
   * @param most how many windows at most, the fullest first
   */
  public static List<Double> of(DoubleStream values, double width, int most) {
    double[] sorted = values.sorted().toArray();
    Map<Long, Integer> counts = new TreeMap<>();
    for (double value : sorted) {
      counts.merge(Math.round(value / width), 1, Integer::sum);
    }
    return counts.entrySet().stream()
        .sorted(
            Map.Entry.<Long, Integer>comparingByValue(Comparator.reverseOrder())
                .thenComparing(Map.Entry::getKey))
        .limit(most)
        .map(window -> median(sorted, window.getKey() * width, width))
        .toList();
  }

  private static double median(double[] sorted, double middle, double width) {
    double[] within =
        Arrays.stream(sorted).filter(value -> Math.abs(value - middle) <= width / 2).toArray();
    return within.length == 0 ? middle : within[within.length / 2];
  }

  /** Returns the value below which a share of the values lie; values sorted, at least one. */
  public static double quantile(double[] sorted, double share) {
    return sorted[(int) Math.min(sorted.length - 1, Math.round(share * (sorted.length - 1)))];
  }
}
