package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.SensorLaw;

/**
 * The constants that decide: how probable something without a name is by its {@link Signs}, and for
 * how much likelihoods are taken. They stand in one file with where they come from, and
 * benchmarks/fit-constants fits them anew.
 *
 * @param least probability of something without a name where no sign speaks for it
 * @param most the same where all do: the share of such logs in which something had no name
 * @param base of the regression
 * @param weights of the signs, by name
 * @param thresholdTemperature by which nats are divided under the threshold rule, positive
 * @param levelTemperature the same under the level law
 * @param namedRightly share of the named effects that were there, in logs that were checked
 */
public record Constants(
    double least,
    double most,
    double base,
    Map<String, Double> weights,
    double thresholdTemperature,
    double levelTemperature,
    double namedRightly) {
  private static final String FORMAT = "simbad-constants/1";
  private static final Constants OWN = of(FittedConstants.of(Constants.class));

  /** Copies the weights, in their order. */
  public Constants {
    Checks.share("least", least);
    Checks.share("most", most);
    Checks.finite("base", base);
    Checks.positive("thresholdTemperature", thresholdTemperature);
    Checks.positive("levelTemperature", levelTemperature);
    Checks.share("namedRightly", namedRightly);
    weights = Collections.unmodifiableMap(new LinkedHashMap<>(weights));
  }

  /** Returns those that the diagnosis uses. */
  public static Constants own() {
    return OWN;
  }

  /**
   * Reads constants.
   *
   * @param root of a file of format "simbad-constants/1"
   * @throws IllegalArgumentException if a field is missing or no number
   */
  public static Constants of(JsonNode root) {
    FittedConstants.check(root, FORMAT);
    JsonNode unknown = root.path("unknown");
    Map<String, Double> weights = new LinkedHashMap<>();
    for (String name : Signs.NONE.byName().keySet()) {
      weights.put(name, FittedConstants.number(unknown, name));
    }
    JsonNode temperature = root.path("temperature");
    return new Constants(
        FittedConstants.number(unknown, "least"),
        FittedConstants.number(unknown, "most"),
        FittedConstants.number(unknown, "base"),
        weights,
        FittedConstants.number(temperature, "threshold"),
        FittedConstants.number(temperature, "level"),
        FittedConstants.number(root, "named_rightly"));
  }

  /** Returns the temperature under a law. */
  public double temperature(SensorLaw.Model law) {
    return law == SensorLaw.Model.LEVEL ? levelTemperature : thresholdTemperature;
  }

  /**
   * Returns how probable it is, by some signs, that something without a name is at work: what the
   * fitted logistic regression says, within the bounds of what it may say.
   */
  public double unknown(Map<String, Double> signs) {
    return unknown(signs, 1);
  }

  /**
   * Returns the same where something that has no name was fitted as well.
   *
   * @param signs by name
   * @param namedShare how probable the named set is among it and what has no name, in [0, 1]
   */
  public double unknown(Map<String, Double> signs, double namedShare) {
    Checks.share("namedShare", namedShare);
    double logit = base;
    for (Map.Entry<String, Double> weight : weights.entrySet()) {
      logit += weight.getValue() * signs.getOrDefault(weight.getKey(), 0.0);
    }
    // What no set of effects that was tried accounts for is often one that the search did not find:
    // the bound is of all that says so, signs and fits alike.
    double nothingElse = namedShare / (1 + Math.exp(logit));
    return least + (most - least) * (1 - nothingElse);
  }
}
