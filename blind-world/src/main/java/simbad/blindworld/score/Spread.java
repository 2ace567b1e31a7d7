package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import simbad.blindworld.world.Chance;

/** The median of a sample with a bootstrap interval. */
final class Spread {

  private static final int RESAMPLES = 1000;
  private static final long SEED = 20140901;

  private Spread() {}

  static double median(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    int n = sorted.size();
    return n % 2 == 1 ? sorted.get(n / 2) : (sorted.get(n / 2 - 1) + sorted.get(n / 2)) / 2;
  }

  /**
   * The 95 % percentile interval of a statistic by bootstrap (Efron 1979, Ann. Statist. 7, 1);
   * empty for an empty sample. A calibration error can only grow by chance, and so does its
   * interval.
   */
  static <T> List<Double> interval95(List<T> sample, ToDoubleFunction<List<T>> statistic) {
    if (sample.isEmpty()) {
      return List.of();
    }
    Chance random = new Chance(SEED);
    List<Double> values = new ArrayList<>();
    for (int i = 0; i < RESAMPLES; i++) {
      List<T> again = random.ints(sample.size(), 0, sample.size()).mapToObj(sample::get).toList();
      values.add(statistic.applyAsDouble(again));
    }
    values.sort(null);
    return List.of(values.get(RESAMPLES / 40), values.get(RESAMPLES - 1 - RESAMPLES / 40));
  }

  /** Median and its 95 % bootstrap interval; only the count for an empty sample. */
  static Map<String, Object> json(List<Double> values) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("n", values.size());
    if (!values.isEmpty()) {
      List<Double> interval = interval95(values, Spread::median);
      json.put("median", median(values));
      json.put("low95", interval.get(0));
      json.put("high95", interval.get(1));
    }
    return json;
  }
}
