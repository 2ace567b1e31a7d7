package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;

/**
 * The constants that decide under the level law, where something that has no name is weighed
 * against the named set: how many times as likely it is is one sign among others.
 *
 * @param weights of {@link #SIGNS}, by name
 * @param temperature by which nats are divided, positive
 * @param namedRightly share of the named effects that were there, in logs that were checked
 */
public record LevelConstants(Map<String, Double> weights, double temperature, double namedRightly)
    implements LawConstants {
  /** Name of the sign of what was weighed against the named set. */
  public static final String STRANGERS_ODDS = "strangers_odds";

  /** What the regression weighs: signs, and what follows from them. */
  public static final List<String> SIGNS =
      List.of(
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

  /** Copies the weights, in their order. */
  public LevelConstants {
    Checks.positive("temperature", temperature);
    Checks.share("namedRightly", namedRightly);
    weights = LawConstants.copy(weights);
  }

  static LevelConstants of(JsonNode law) {
    return new LevelConstants(
        LawConstants.weights(law.path("unknown"), SIGNS),
        FittedConstants.number(law, "temperature"),
        FittedConstants.number(law, "named_rightly"));
  }

  @Override
  public double unknown(Map<String, Double> signs) {
    double share = LawConstants.share(weights, weighed(signs));
    return Math.max(SUREST, Math.min(1 - SUREST, share));
  }

  /** Returns the signs, and what follows from them. */
  private static Map<String, Double> weighed(Map<String, Double> signs) {
    double misfit = signs.getOrDefault("misfit", 0.0);
    double odds = Math.log(signs.getOrDefault(STRANGERS_ODDS, 1.0));
    Map<String, Double> all = new LinkedHashMap<>(signs);
    all.put("misfit", Math.min(LARGE_MISFIT, misfit));
    all.put("misfit_large", Math.max(0, misfit - LARGE_MISFIT));
    all.put("strangers_likelier", Math.max(0, Math.min(MOST_NATS, odds)));
    all.put("strangers_less_likely", Math.min(0, Math.max(-MOST_NATS, odds)));
    return all;
  }

  @Override
  public double besideARest(double unknown) {
    return Math.max(0.5, unknown);
  }
}
