package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckScores;

/** Scores in the scorer's format with round figures: 40 cases, 30 of them L1 and 10 L2. */
final class SampleScores {
  static final String ALL = "all cases (L1 and L2)";
  static final String L1 = "set-up as believed (L1)";
  static final String L2 = "set-up off, with reference (L2)";

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private SampleScores() {}

  static CheckOrder order(String... withheld) {
    return new CheckOrder(
        "0.0 (commit unknown)",
        new CheckOrder.Drawn(40, 3, 0.25, List.of("--rows", "300-400")),
        List.of(withheld));
  }

  static CheckOrder foreign() {
    return new CheckOrder(
        "0.0 (commit unknown)",
        new CheckOrder.Foreign("their <sets>", Optional.of("L3")),
        List.of());
  }

  static CheckScores scores() {
    ObjectNode document = MAPPER.createObjectNode();
    document.put("format", "blind-scores/1");
    document.put("commitments", "40 verified against manifest.json");
    document.put("answers_sha256", "ab".repeat(32));
    ObjectNode parts = document.putObject("scores");
    for (String part : List.of(ALL, L1, L2)) {
      ObjectNode sorts = parts.putObject(part);
      for (String sort : CheckScores.SORTS) {
        sorts.set(sort, figures(part.equals(ALL) ? 40 : part.equals(L1) ? 30 : 10));
      }
    }
    addCases(document.putArray("cases"));
    return new CheckScores(document);
  }

  private static ObjectNode figures(int cases) {
    ObjectNode figures = MAPPER.createObjectNode();
    figures.put("cases", cases);
    ObjectNode shares = figures.putObject("shares");
    share(shares.putObject("all verdicts right"), cases * 9 / 10, cases);
    share(shares.putObject("all wrongly explained"), cases / 10, cases);
    share(shares.putObject("none called none"), cases / 4, cases / 4);
    share(shares.putObject("singles named and explained"), cases / 5, cases / 4);
    share(shares.putObject("withheld called unexplained"), 0, 0);
    figures
        .putObject("unknown")
        .put("unknown_cases", 5)
        .put("known_cases", cases - 5)
        .put("auroc", 0.96)
        .put("auroc_low95", 0.9)
        .put("auroc_high95", 1);
    calibration(figures.putObject("verdict_calibration"), cases);
    calibration(figures.putObject("first_named_calibration"), cases);
    figures.put("class_mean", 0.9);
    figures.putArray("class_mean_ci95").add(0.85).add(0.95);
    figures.put("probability_of_truth", 0.8);
    figures.putArray("probability_of_truth_ci95").add(0.7).add(0.85);
    figures.put("verdict_log_score_better_by", 0.7);
    figures.putArray("verdict_log_score_better_by_ci95").add(0.5).add(0.8);
    figures
        .putObject("shrink_claimed_minus_sealed_points")
        .put("n", 9)
        .put("median", 3.25)
        .put("low95", 1.5)
        .put("high95", 30);
    figures.putObject("share_of_oracle_removal").put("n", 0);
    figures
        .putArray("effects_worst_first")
        .addObject()
        .put("effect", "(wind)")
        .put("hits", 1)
        .put("of", 2)
        .put("share", 0.5)
        .put("low95", 0.1)
        .put("high95", 0.9);
    ObjectNode kinds = figures.putObject("kinds");
    kinds.putObject("single").put("explained, named rightly", 8).put("none", 2);
    kinds.putObject("none").put("none", 10);
    figures.putObject("standings").putObject("single").put("right", 8).put("cautious", 2);
    ObjectNode confusion = figures.putObject("confusion");
    confusion.putObject("gain").put("gain", 3).put("gain+latency", 1).put("gain+wind", 1);
    confusion.putObject("gain+latency").put("gain+latency", 4);
    confusion.putObject("none").put("none", 10).put("(no answer)", 1);
    return figures;
  }

  private static ObjectNode share(ObjectNode share, int hits, int of) {
    return share
        .put("hits", hits)
        .put("of", of)
        .put("share", of == 0 ? 0 : (double) hits / of)
        .put("low95", of == 0 ? 0 : 0.8 * hits / of)
        .put("high95", 1);
  }

  private static void calibration(ObjectNode json, int cases) {
    json.put("n", cases).put("ece", 0.04).put("better_by", 0.65);
    json.putArray("ece_ci95").add(0.02).add(0.09);
    json.putArray("better_by_ci95").add(0.4).add(0.8);
    ArrayNode curve = json.putArray("curve");
    for (int bin = 1; bin <= 10; bin++) {
      share(curve.addObject().put("stated", bin / 10.0 - 0.04), bin, 10);
    }
  }

  private static void addCases(ArrayNode cases) {
    for (int i = 0; i < 40; i++) {
      ObjectNode one = cases.addObject();
      one.put("case", "c" + i).put("level", i < 30 ? "L1" : "L2").put("kind", "single");
      one.put("so", "gain").put("said", i == 0 ? "(no answer)" : i == 1 ? "<b>" : "gain");
      one.put("right", i > 1);
      if (i > 0) {
        one.put("verdict", "explained").put("verdict_probability", 0.9);
        one.put("unknown_probability", 0.05).put("shrink_claimed", 0.02 * i);
        one.put("shrink_sealed", 0.02 * i - 0.1);
      }
    }
  }
}
