package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/** Probabilities against what was so: expected calibration error and log score. */
final class Calibration {

  private static final int BINS = 10;
  private static final double LEAST = 1e-4;

  private Calibration() {}

  /** A stated probability, and whether it was so. */
  record Claim(double probability, boolean so) {}

  /** The mean distance of stated probability and share, over ten bins of equal mass. */
  static double expectedError(List<Claim> claims) {
    double sum = 0;
    for (List<Claim> bin : bins(claims)) {
      sum += bin.size() * Math.abs(stated(bin) - share(bin));
    }
    return claims.isEmpty() ? 0 : sum / claims.size();
  }

  private static List<List<Claim>> bins(List<Claim> claims) {
    List<Claim> sorted = new ArrayList<>(claims);
    sorted.sort(Comparator.comparingDouble(Claim::probability));
    List<List<Claim>> bins = new ArrayList<>();
    int n = sorted.size();
    for (int b = 0; b < BINS; b++) {
      List<Claim> bin = sorted.subList(b * n / BINS, (b + 1) * n / BINS);
      if (!bin.isEmpty()) {
        bins.add(bin);
      }
    }
    return bins;
  }

  private static double stated(List<Claim> bin) {
    return bin.stream().mapToDouble(Claim::probability).average().orElse(0);
  }

  private static double share(List<Claim> bin) {
    return bin.stream().mapToDouble(c -> c.so() ? 1 : 0).average().orElse(0);
  }

  /** The mean of minus the log of what was said of what was so. */
  static double logScore(List<Claim> claims) {
    return claims.stream()
        .mapToDouble(c -> loss(c.so() ? c.probability() : 1 - c.probability()))
        .average()
        .orElse(0);
  }

  static double loss(double probability) {
    return -StrictMath.log(Math.max(LEAST, Math.min(1, probability)));
  }

  /** The log score of always stating the share. */
  static double baseScore(List<Claim> claims) {
    double share = share(claims);
    return logScore(claims.stream().map(c -> new Claim(share, c.so())).toList());
  }

  static Map<String, Object> json(List<Claim> claims) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("n", claims.size());
    json.put("ece", expectedError(claims));
    json.put("ece_ci95", Spread.interval95(claims, Calibration::expectedError));
    json.put("log_score", logScore(claims));
    json.put("log_score_of_base_rate", baseScore(claims));
    findBetterBy(claims)
        .ifPresent(
            share -> {
              json.put("better_by", share);
              json.put("better_by_ci95", Spread.interval95(claims, Calibration::betterBy));
            });
    json.put("curve", curve(claims));
    return json;
  }

  /**
   * By which share the log score is better than that of base rates; none where all or none were so.
   */
  static OptionalDouble findBetterBy(List<Claim> claims) {
    return baseScore(claims) > LEAST ? OptionalDouble.of(betterBy(claims)) : OptionalDouble.empty();
  }

  private static double betterBy(List<Claim> claims) {
    return better(logScore(claims), baseScore(claims));
  }

  static double better(double score, double base) {
    return base > 0 ? 1 - score / base : 0;
  }

  private static List<Object> curve(List<Claim> claims) {
    List<Object> curve = new ArrayList<>();
    for (List<Claim> bin : bins(claims)) {
      int so = (int) bin.stream().filter(Claim::so).count();
      Map<String, Object> point = new LinkedHashMap<>();
      point.put("stated", stated(bin));
      point.putAll(new Proportion(so, bin.size()).json());
      curve.add(point);
    }
    return curve;
  }
}
