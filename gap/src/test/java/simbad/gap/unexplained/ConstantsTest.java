package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import simbad.sonar.scene.SensorLaw;

class ConstantsTest {
  private static Constants levels(Map<String, Double> weights) {
    Map<String, Double> all = new LinkedHashMap<>();
    all.put(LawConstants.BASE, weights.getOrDefault(LawConstants.BASE, 0.0));
    LevelConstants.SIGNS.forEach(sign -> all.put(sign, weights.getOrDefault(sign, 0.0)));
    return new Constants(
        new ThresholdConstants(0.005, 0.8, Map.of(LawConstants.BASE, -4.0, "misfit", 1.0), 1, 0.95),
        new LevelConstants(all, 1, 0.95));
  }

  /** Signs of either law count under that law alone. */
  @Test
  void eachLaw_hasItsOwnWeights() {
    Constants constants = levels(Map.of("base", -1.0, "left", 2.0));
    Map<String, Double> signs = Map.of("misfit", 4.0, "left", 1.0);
    assertEquals(
        0.005 + 0.795 / 2, constants.under(SensorLaw.Model.THRESHOLD).unknown(signs), 1e-12);
    assertEquals(
        1 / (1 + Math.exp(-1)), constants.under(SensorLaw.Model.LEVEL).unknown(signs), 1e-12);
  }

  /** Misfit over 4 is a sign of its own, and odds count by their logarithm up to 10 either way. */
  @Test
  void whatFollowsFromSigns_isWeighedUnderTheLevelLaw() {
    Constants large = levels(Map.of("misfit", 1.0, "misfit_large", -2.0));
    assertEquals(1 / (1 + Math.exp(-4)), large.level().unknown(Map.of("misfit", 4.0)), 1e-12);
    assertEquals(0.5, large.level().unknown(Map.of("misfit", 6.0)), 1e-12);
    Constants odds = levels(Map.of("strangers_likelier", 0.1, "strangers_less_likely", 0.2));
    assertEquals(0.5, odds.level().unknown(Map.of()), 1e-12, "as likely");
    assertEquals(1 / (1 + Math.exp(-0.5)), odds.level().unknown(strange(Math.exp(5))), 1e-12);
    assertEquals(1 / (1 + Math.exp(-1)), odds.level().unknown(strange(1e30)), 1e-12);
    assertEquals(1 / (1 + Math.exp(1)), odds.level().unknown(strange(Math.exp(-5))), 1e-12);
    assertEquals(1 / (1 + Math.exp(2)), odds.level().unknown(strange(0)), 1e-12);
  }

  private static Map<String, Double> strange(double odds) {
    return Map.of(LevelConstants.STRANGERS_ODDS, odds);
  }

  @Test
  void nothingIsSurerThanSignsCanSay() {
    assertEquals(0.995, levels(Map.of("base", 40.0)).level().unknown(Map.of()), 1e-12);
    assertEquals(0.005, levels(Map.of("base", -40.0)).level().unknown(Map.of()), 1e-12);
  }

  /** What was fitted: what is likelier than the named set speaks for something without a name. */
  @Test
  void likelierStrangers_makeTheUnknownProbable() {
    Constants own = Constants.own();
    double unlikely = own.level().unknown(strange(1e-3));
    double likely = own.level().unknown(strange(1e6));
    assertTrue(unlikely < 0.1 && likely > 3 * unlikely, () -> unlikely + " and " + likely);
  }
}
