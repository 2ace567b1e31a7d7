package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;

/**
 * The constants that decide under the threshold rule.
 *
 * @param least probability of something without a name where no sign speaks for it
 * @param most the same where all do: the share of such logs in which something had no name
 * @param weights of the signs, by name
 * @param temperature by which nats are divided, positive
 * @param namedRightly share of the named effects that were there, in logs that were checked
 */
public record ThresholdConstants(
    double least, double most, Map<String, Double> weights, double temperature, double namedRightly)
    implements LawConstants {
  /** Copies the weights, in their order. */
  public ThresholdConstants {
    Checks.share("least", least);
    Checks.share("most", most);
    Checks.positive("temperature", temperature);
    Checks.share("namedRightly", namedRightly);
    weights = LawConstants.copy(weights);
  }

  static ThresholdConstants of(JsonNode law) {
    JsonNode unknown = law.path("unknown");
    return new ThresholdConstants(
        FittedConstants.number(unknown, "least"),
        FittedConstants.number(unknown, "most"),
        LawConstants.weights(unknown, Signs.NONE.byName().keySet()),
        FittedConstants.number(law, "temperature"),
        FittedConstants.number(law, "named_rightly"));
  }

  /** What the regression says, within the bounds of what it may say. */
  @Override
  public double unknown(Map<String, Double> signs) {
    // What no set of effects that was tried accounts for is often one that the search did not find.
    return least + (most - least) * LawConstants.share(weights, signs);
  }

  @Override
  public double besideARest(double unknown) {
    return most;
  }
}
