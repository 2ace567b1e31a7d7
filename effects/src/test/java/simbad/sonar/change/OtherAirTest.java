package simbad.sonar.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.level.Air;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;

/** Air of another temperature: sound is faster or slower, and is absorbed otherwise. */
class OtherAirTest {
  private static final SensingSetup SETUP =
      new SensingSetup(
              new SonarSpec(
                  "s",
                  Math.toRadians(20),
                  0.02,
                  4,
                  0.1,
                  Air.ROOM.soundSpeedMPerS(),
                  0.01,
                  0.005,
                  0.02,
                  0.03,
                  0.05),
              new Scene(List.of()),
              4)
          .under(SensorLaw.Model.LEVEL);
  private static final Definition SPEED = Definitions.of(Effect.SOUND_SPEED);
  private static final Form AIR =
      Forms.find(Effect.SOUND_SPEED, "air", SETUP, List.of("s")).orElseThrow();

  /** What the standard says of either air, and no more than a speed of sound has to do with it. */
  @ParameterizedTest
  @CsvSource({"0, 50", "7, 20", "35, 30", "20, 80"})
  void colderAir_isSlower_andTakesLess(double temperatureC, double humidityPercent) {
    Air real = new Air(temperatureC, humidityPercent);
    Air assumed = new Air(20, humidityPercent);
    OtherAir air = (OtherAir) AIR.with(real.soundSpeedMPerS(), humidityPercent);
    assertEquals(
        real.absorptionDbPerM(40_000) - assumed.absorptionDbPerM(40_000),
        air.absorption().addedDbPerM(),
        1e-9);
    assertEquals(Air.ROOM.soundSpeedMPerS() / real.soundSpeedMPerS(), air.meanM(1), 1e-12);
    assertEquals(1, air.rangeM(air.meanM(1)), 1e-12);
  }

  @Test
  void neutral_isTheAirThatIsAssumed() {
    OtherAir air = (OtherAir) AIR.with(AIR.neutral());
    assertEquals(1, air.meanM(1));
    assertEquals(0, air.absorption().addedDbPerM());
  }

  /** Beyond what the formula of absorption is for, the last that it says is taken. */
  @Test
  void whatIsNoAir_absorbsAsTheLastThatIs() {
    OtherAir last = (OtherAir) AIR.with(new Air(60, 50).soundSpeedMPerS(), 50);
    OtherAir beyond = (OtherAir) AIR.with(371, 50);
    assertEquals(last.absorption().addedDbPerM(), beyond.absorption().addedDbPerM(), 1e-9);
  }

  @Test
  void remedy_saysBothSymptoms() {
    String remedy =
        SPEED.remedy(
            new FittedValues(
                Map.of("sound_speed_m_s", 331.3, "humidity_percent", 50.0), SETUP.sensor()));
    assertTrue(remedy.startsWith("compute with 331.3 m/s (air of 0 degrees), not 343.2"), remedy);
    assertTrue(remedy.endsWith("; it takes 0.9 dB/m less of an echo"), remedy);
  }

  /** The threshold rule knows of no absorption. */
  @Test
  void form_isOfTheLevelLawAlone() {
    SensingSetup threshold = SETUP.under(SensorLaw.Model.THRESHOLD);
    assertFalse(
        Forms.of(SPEED, threshold, List.of("s")).stream().anyMatch(f -> f.name().equals("air")));
    assertEquals(
        331.3,
        SPEED.corrected(SETUP, AIR, 331.3, 50).orElseThrow().sensor().assumedSoundSpeedMPerS());
    assertTrue(SPEED.isWithinDays(AIR, Air.ROOM.soundSpeedMPerS() + 0.3, 50));
    assertFalse(SPEED.isWithinDays(AIR, 331.3, 50));
  }
}
