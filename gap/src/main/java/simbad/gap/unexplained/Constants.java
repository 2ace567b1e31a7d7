package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.SensorLaw;

/**
 * The constants that decide: how probable something without a name is by its {@link Signs}, and for
 * how much likelihoods are taken, under either law of hearing. They stand in one file with where
 * they come from, and benchmarks/fit-constants fits them anew.
 *
 * @param least under the threshold rule, probability of something without a name where no sign
 *     speaks for it
 * @param most the same where all do: the share of such logs in which something had no name
 * @param base of the regression under the threshold rule
 * @param weights of the signs there, by name
 * @param levelWeights of the regression under the level law, by name: {@link #LEVEL_SIGNS}
 * @param thresholdTemperature by which nats are divided under the threshold rule, positive
 * @param levelTemperature the same under the level law
 * @param thresholdNamedRightly share of the named effects that were there, in logs that were
 *     checked, under the threshold rule
 * @param levelNamedRightly the same under the level law
 */
public record Constants(
    double least,
    double most,
    double base,
    Map<String, Double> weights,
    Map<String, Double> levelWeights,
    double thresholdTemperature,
    double levelTemperature,
    double thresholdNamedRightly,
    double levelNamedRightly) {
  /** Name of the sign of what was weighed against the named set, under the level law alone. */
  public static final String STRANGERS_ODDS = "strangers_odds";

  /** What the level law's regression weighs: a constant, the signs, and what follows from them. */
  public static final List<String> LEVEL_SIGNS =
      List.of(
          "base",
          "misfit",
          "misfit_large",
          "left",
          "left_little",
          "share_left",
          "soaks",
          "many",
          "two_for_little",
          "stand_in",
          "strangers_likelier",
          "strangers_less_likely");

  /**
   * So much misfit is more than what has no name makes: what the search did not find is as large.
   */
  private static final double LARGE_MISFIT = 4;

  /** Beyond, in natural logarithms, odds say no more. */
  private static final double MOST_NATS = 10;

  /** Nothing is surer by signs. */
  private static final double SUREST = 0.005;

  private static final String NAMED_RIGHTLY = "named_rightly";
  private static final String FORMAT = "simbad-constants/2";
  private static final Constants OWN = of(FittedConstants.of(Constants.class));

  /** Copies the weights, in their order. */
  public Constants {
    Checks.share("least", least);
    Checks.share("most", most);
    Checks.finite("base", base);
    Checks.positive("thresholdTemperature", thresholdTemperature);
    Checks.positive("levelTemperature", levelTemperature);
    Checks.share("thresholdNamedRightly", thresholdNamedRightly);
    Checks.share("levelNamedRightly", levelNamedRightly);
    weights = copy(weights);
    levelWeights = copy(levelWeights);
  }

  private static Map<String, Double> copy(Map<String, Double> weights) {
    weights.forEach(Checks::finite);
    return Collections.unmodifiableMap(new LinkedHashMap<>(weights));
  }

  /** Returns those that the diagnosis uses. */
  public static Constants own() {
    return OWN;
  }

  /**
   * Reads constants.
   *
   * @param root of a file of format "simbad-constants/2"
   * @throws IllegalArgumentException if a field is missing or no number
   */
  public static Constants of(JsonNode root) {
    FittedConstants.check(root, FORMAT);
    JsonNode threshold = root.path("threshold");
    JsonNode unknown = threshold.path("unknown");
    JsonNode level = root.path("level");
    return new Constants(
        FittedConstants.number(unknown, "least"),
        FittedConstants.number(unknown, "most"),
        FittedConstants.number(unknown, "base"),
        weights(unknown, Signs.NONE.byName().keySet()),
        weights(level.path("unknown"), LEVEL_SIGNS),
        FittedConstants.number(threshold, "temperature"),
        FittedConstants.number(level, "temperature"),
        FittedConstants.number(threshold, NAMED_RIGHTLY),
        FittedConstants.number(level, NAMED_RIGHTLY));
  }

  private static Map<String, Double> weights(JsonNode node, Collection<String> names) {
    Map<String, Double> weights = new LinkedHashMap<>();
    names.forEach(name -> weights.put(name, FittedConstants.number(node, name)));
    return weights;
  }

  /** Returns the share of named effects that were there under a law. */
  public double namedRightly(SensorLaw.Model law) {
    return law == SensorLaw.Model.LEVEL ? levelNamedRightly : thresholdNamedRightly;
  }

  /** Returns the temperature under a law. */
  public double temperature(SensorLaw.Model law) {
    return law == SensorLaw.Model.LEVEL ? levelTemperature : thresholdTemperature;
  }

  /**
   * Returns how probable it is, by some signs, that something without a name is at work under the
   * threshold rule: what the fitted logistic regression says, within the bounds of what it may say.
   *
   * @param signs by name; those that are missing count as 0
   */
  public double unknown(Map<String, Double> signs) {
    // What no set of effects that was tried accounts for is often one that the search did not find.
    return least + (most - least) * share(base + sum(weights, signs));
  }

  /**
   * Returns the same under the level law, where something that has no name was weighed against the
   * named set ({@link #STRANGERS_ODDS}): how many times as likely it is is one sign among others.
   */
  public double unknownByLevels(Map<String, Double> signs) {
    double share = share(sum(levelWeights, levelSigns(signs)));
    return Math.max(SUREST, Math.min(1 - SUREST, share));
  }

  /** Returns the probability under a law. */
  public double unknown(SensorLaw.Model law, Map<String, Double> signs) {
    return law == SensorLaw.Model.LEVEL ? unknownByLevels(signs) : unknown(signs);
  }

  /** Returns what the level law's regression weighs, in the order of its weights. */
  private static Map<String, Double> levelSigns(Map<String, Double> signs) {
    double misfit = signs.getOrDefault("misfit", 0.0);
    double odds = Math.log(signs.getOrDefault(STRANGERS_ODDS, 1.0));
    Map<String, Double> all = new LinkedHashMap<>(signs);
    all.put("base", 1.0);
    all.put("misfit", Math.min(LARGE_MISFIT, misfit));
    all.put("misfit_large", Math.max(0, misfit - LARGE_MISFIT));
    all.put("strangers_likelier", Math.max(0, Math.min(MOST_NATS, odds)));
    all.put("strangers_less_likely", Math.min(0, Math.max(-MOST_NATS, odds)));
    return all;
  }

  private static double sum(Map<String, Double> weights, Map<String, Double> signs) {
    double sum = 0;
    for (Map.Entry<String, Double> weight : weights.entrySet()) {
      sum += weight.getValue() * signs.getOrDefault(weight.getKey(), 0.0);
    }
    return sum;
  }

  private static double share(double logOdds) {
    return 1 / (1 + Math.exp(-logOdds));
  }
}
