package simbad.gap.motion;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.gap.diagnosis.Verdict;
import simbad.sonar.check.Checks;

/**
 * How sure a diagnosis of motion is, by its {@link MotionSigns}: logistic regressions whose weights
 * stand in one file with where they come from. benchmarks/fit-motion fits them anew.
 *
 * @param none log odds of none against explained: base and weights of signs, by name
 * @param unexplained the same of something without a name
 * @param namedRightly log odds that a concluded effect is at work
 * @param otherDrive logarithm of the factor by which what is left of the gap differs on another
 *     drive, at most, 19 times of 20
 */
public record MotionConstants(
    Map<String, Double> none,
    Map<String, Double> unexplained,
    Map<String, Double> namedRightly,
    double otherDrive) {
  /** What stands beside the weights. */
  public static final String BASE = "base";

  /** Signs that tell the verdict. */
  public static final List<String> VERDICT_SIGNS =
      List.of("named", "stranger", "stranger_beside", "left_beside", "left_alone");

  /** Signs that tell whether a name is right. */
  public static final List<String> NAME_SIGNS = List.of("stranger", "worth", "scatters");

  private static final String FORMAT = "simbad-motion-constants/1";
  private static final MotionConstants OWN = of(FittedConstants.of(MotionConstants.class));

  /** Copies the weights, in their order. */
  public MotionConstants {
    Checks.positive("otherDrive", otherDrive);
    none = copy(none);
    unexplained = copy(unexplained);
    namedRightly = copy(namedRightly);
  }

  private static Map<String, Double> copy(Map<String, Double> weights) {
    weights.forEach(Checks::finite);
    return Collections.unmodifiableMap(new LinkedHashMap<>(weights));
  }

  /** Returns those that the diagnosis uses. */
  public static MotionConstants own() {
    return OWN;
  }

  /**
   * Reads constants.
   *
   * @param root of a file of format "simbad-motion-constants/1"
   * @throws IllegalArgumentException if a field is missing or no number
   */
  public static MotionConstants of(JsonNode root) {
    FittedConstants.check(root, FORMAT);
    return new MotionConstants(
        weights(root.path("none"), VERDICT_SIGNS),
        weights(root.path("unexplained"), VERDICT_SIGNS),
        weights(root.path("named_rightly"), NAME_SIGNS),
        FittedConstants.number(root, "other_drive"));
  }

  private static Map<String, Double> weights(JsonNode node, List<String> signs) {
    Map<String, Double> weights = new LinkedHashMap<>();
    weights.put(BASE, FittedConstants.number(node, BASE));
    signs.forEach(sign -> weights.put(sign, FittedConstants.number(node, sign)));
    return weights;
  }

  /**
   * Returns how probable it is that a verdict is the right one. None, explained and unexplained add
   * up to 1; partly has the probability of unexplained, undecided has 0.
   *
   * @param of which verdict
   * @param signs by name; those that are missing count as 0
   */
  public double verdict(Verdict of, Map<String, Double> signs) {
    double nothing = Math.exp(logOdds(none, signs));
    double stranger = Math.exp(logOdds(unexplained, signs));
    double sum = 1 + nothing + stranger;
    return switch (of) {
      case NONE -> nothing / sum;
      case EXPLAINED -> 1 / sum;
      case PARTLY, UNEXPLAINED -> stranger / sum;
      case UNDECIDED -> 0;
    };
  }

  /**
   * Returns how probable it is that an effect is at work that is sure by its weight alone.
   *
   * @param signs by name; an effect without a worth is one that only scatters
   * @param effect its name
   */
  public double namedRightly(Map<String, Double> signs, String effect) {
    Map<String, Double> own = new LinkedHashMap<>(signs);
    Double worth = signs.get(MotionSigns.WORTH + effect);
    own.put("worth", worth == null ? 0 : worth);
    own.put("scatters", worth == null ? 1.0 : 0.0);
    return NormalChance.ofLogOdds(logOdds(namedRightly, own));
  }

  /** Returns the names of the effects that signs have a worth of. */
  public static List<String> weighed(Map<String, Double> signs) {
    return signs.keySet().stream()
        .filter(sign -> sign.startsWith(MotionSigns.WORTH))
        .map(sign -> sign.substring(MotionSigns.WORTH.length()))
        .toList();
  }

  private static double logOdds(Map<String, Double> weights, Map<String, Double> signs) {
    double sum = 0;
    for (Map.Entry<String, Double> weight : weights.entrySet()) {
      double sign = weight.getKey().equals(BASE) ? 1 : signs.getOrDefault(weight.getKey(), 0.0);
      sum += weight.getValue() * sign;
    }
    return sum;
  }
}
