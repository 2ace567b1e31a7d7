package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;

class HtmlTest {
  @ParameterizedTest
  @CsvSource({
    "0.123456, 0.123",
    "1234567, 1230000",
    "-0.5, \u22120.5",
    "0, 0",
    "1e-9, 0",
    "NaN, unknown",
    "Infinity, no bound",
    "-Infinity, no bound",
    "343.139, 343"
  })
  void numbers_haveThreeDigits(double value, String text) {
    assertEquals(text, Html.number(value));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 100&nbsp;%",
    "0.999, &gt;&nbsp;99&nbsp;%",
    "0.991, 99&nbsp;%",
    "0.004, &lt;&nbsp;1&nbsp;%",
    "0, 0&nbsp;%",
    "0.5, 50&nbsp;%"
  })
  void probabilities_areNotRoundedToCertainty(double share, String text) {
    assertEquals(text, Html.probability(share));
  }

  @Test
  void fixed_hasNoMinusBeforeNothing() {
    assertEquals("0.00", Html.fixed(-0.001, 2));
    assertEquals("\u22121.50", Html.fixed(-1.5, 2));
  }

  @Test
  void lists_readLikeASentence() {
    assertEquals("", Html.list(List.of()));
    assertEquals("gain", Html.list(List.of(Effect.GAIN)));
    assertEquals(
        "gain, latency and dropout",
        Html.list(List.of(Effect.GAIN, Effect.LATENCY, Effect.DROPOUT)));
  }

  /** Every name of the vocabulary has a meaning, and no two the same. */
  @Test
  void effects_areExplained() {
    assertEquals(
        Definitions.effects().size(),
        Definitions.effects().stream().map(VerdictWords::meaning).distinct().count());
  }

  @ParameterizedTest
  @CsvSource({
    "sound_speed_m_s, &nbsp;m/s",
    "rate_deg_s, &nbsp;°/s",
    "turn_deg, °",
    "offset_m, &nbsp;m",
    "delay_s, &nbsp;s",
    "loss_per_m, &nbsp;1/m",
    "pings, &nbsp;pings",
    "factor, ''",
    "threshold_5_deg_m, &nbsp;m",
    "max_turn_rad_s, &nbsp;rad/s",
    "speed_factor_per_m_s, &nbsp;per&nbsp;m/s",
    "turn_factor_per_rad_s, &nbsp;per&nbsp;rad/s"
  })
  void units_comeOfNames(String name, String unit) {
    assertEquals(unit, Places.unit(name));
  }
}
