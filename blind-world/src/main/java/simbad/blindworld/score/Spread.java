package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** The median of a sample with a bootstrap interval. */
final class Spread {

  private static final int RESAMPLES = 2000;
  private static final long SEED = 20140901;

  private Spread() {}

  static double median(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    int n = sorted.size();
    return n % 2 == 1 ? sorted.get(n / 2) : (sorted.get(n / 2 - 1) + sorted.get(n / 2)) / 2;
  }

  /** Median and its 95 % bootstrap interval; only the count for an empty sample. */
  static Map<String, Object> json(List<Double> values) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("n", values.size());
    if (!values.isEmpty()) {
      SplittableRandom random = new SplittableRandom(SEED);
      List<Double> medians = new ArrayList<>();
      for (int i = 0; i < RESAMPLES; i++) {
        List<Double> sample =
            random.ints(values.size(), 0, values.size()).mapToObj(values::get).toList();
        medians.add(median(sample));
      }
      medians.sort(null);
      json.put("median", median(values));
      json.put("low95", medians.get(RESAMPLES / 40));
      json.put("high95", medians.get(RESAMPLES - 1 - RESAMPLES / 40));
    }
    return json;
  }
}
