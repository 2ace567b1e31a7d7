package simbad.experiments.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.sonar.check.Checks;

/**
 * Stated probabilities against what was so.
 *
 * @param claims how many probabilities were stated
 * @param error expected calibration error; nothing without claims
 * @param betterBy by which share the log score is better than that of base rates
 * @param bins of equal mass, by rising probability
 */
public record StatedProbabilities(
    int claims, Optional<Estimate> error, Optional<Estimate> betterBy, List<Bin> bins) {

  /** Claims of like probability: what they state in the mean, and how many were so. */
  public record Bin(double stated, int hits, int of, double share, double low, double high) {
    /** Checks that all are numbers. */
    public Bin {
      Checks.number("stated", stated);
      Checks.number("share", share);
      Checks.number("low", low);
      Checks.number("high", high);
    }
  }

  static StatedProbabilities of(JsonNode json) {
    int claims = json.path("n").asInt();
    List<Bin> bins = new ArrayList<>();
    for (JsonNode bin : json.path("curve")) {
      bins.add(
          new Bin(
              bin.path("stated").asDouble(),
              bin.path("hits").asInt(),
              bin.path("of").asInt(),
              bin.path("share").asDouble(),
              bin.path("low95").asDouble(),
              bin.path("high95").asDouble()));
    }
    return new StatedProbabilities(
        claims,
        estimate(json, "ece", claims),
        estimate(json, "better_by", claims),
        List.copyOf(bins));
  }

  /** A figure whose interval stands beside it in a field of its own. */
  static Optional<Estimate> estimate(JsonNode json, String name, int count) {
    JsonNode interval = json.path(name + "_ci95");
    return interval.size() != 2
        ? Optional.empty()
        : Optional.of(
            new Estimate(
                json.path(name).asDouble(),
                interval.path(0).asDouble(),
                interval.path(1).asDouble(),
                "n = " + count));
  }
}
