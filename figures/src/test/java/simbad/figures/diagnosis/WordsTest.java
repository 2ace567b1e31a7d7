package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;

class WordsTest {
  @Test
  void lists_readLikeASentence() {
    assertEquals("", Names.list(List.of()));
    assertEquals("gain", Names.list(List.of(Effect.GAIN)));
    assertEquals(
        "gain, latency and dropout",
        Names.list(List.of(Effect.GAIN, Effect.LATENCY, Effect.DROPOUT)));
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
    "sound_speed_m_s, \u00a0m/s",
    "rate_deg_s, \u00a0°/s",
    "turn_deg, °",
    "offset_m, \u00a0m",
    "delay_s, \u00a0s",
    "loss_per_m, \u00a01/m",
    "pings, \u00a0pings",
    "factor, ''",
    "threshold_5_deg_m, \u00a0m",
    "max_turn_rad_s, \u00a0rad/s",
    "speed_factor_per_m_s, \u00a0per\u00a0m/s",
    "turn_factor_per_rad_s, \u00a0per\u00a0rad/s"
  })
  void units_comeOfNames(String name, String unit) {
    assertEquals(unit, PlaceWords.unit(name));
  }
}
