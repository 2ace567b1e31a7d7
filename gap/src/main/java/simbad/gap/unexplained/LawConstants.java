package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;

/** The constants that decide under one law of hearing. */
public sealed interface LawConstants permits ThresholdConstants, LevelConstants {
  /** Name of the constant of a regression among its weights. */
  String BASE = "base";

  /**
   * Returns how probable it is, by some signs, that something without a name is at work.
   *
   * @param signs by name; those that are missing count as 0
   */
  double unknown(Map<String, Double> signs);

  /**
   * Returns the same where so much is left that nothing is explained, whether signs say so or not:
   * a value at the end of a search, or twice the scatter that is expected.
   *
   * @param unknown what signs say
   */
  double besideARest(double unknown);

  /** Returns the weights of the regression, by name, its constant first. */
  Map<String, Double> weights();

  /** Returns by what nats are divided, positive. */
  double temperature();

  /** Returns the share of the named effects that were there, in logs that were checked. */
  double namedRightly();

  /** Returns weights in their order, checked; they cannot be changed. */
  static Map<String, Double> copy(Map<String, Double> weights) {
    weights.forEach(Checks::finite);
    return Collections.unmodifiableMap(new LinkedHashMap<>(weights));
  }

  /** Returns the constant and the weights of some signs. */
  static Map<String, Double> weights(JsonNode node, Collection<String> signs) {
    Map<String, Double> weights = new LinkedHashMap<>();
    weights.put(BASE, FittedConstants.number(node, BASE));
    signs.forEach(name -> weights.put(name, FittedConstants.number(node, name)));
    return weights;
  }

  /** Returns the probability that a regression says. */
  static double share(Map<String, Double> weights, Map<String, Double> signs) {
    double logOdds = 0;
    for (Map.Entry<String, Double> weight : weights.entrySet()) {
      double sign = weight.getKey().equals(BASE) ? 1 : signs.getOrDefault(weight.getKey(), 0.0);
      logOdds += weight.getValue() * sign;
    }
    return 1 / (1 + Math.exp(-logOdds));
  }
}
