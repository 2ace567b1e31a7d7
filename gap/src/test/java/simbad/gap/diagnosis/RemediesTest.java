package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.scene.SonarSpec;

/** Each effect says what to do about it, with its number. */
class RemediesTest {
  private static final SonarSpec SENSOR = Worlds.POST.sensor();

  private static String remedy(Effect effect, String form, double... values) {
    Form of = Forms.find(effect, form, Worlds.POST, List.of("s")).orElseThrow();
    List<FittedParameter> fitted = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      fitted.add(new FittedParameter(of.parameters().get(i).name(), values[i], new Interval(0, 1)));
    }
    return Remedies.of(new EffectFinding(effect, 1, Optional.of(form), fitted, List.of()), SENSOR);
  }

  @Test
  void airHasItsTemperature_anotherFactorIsAUnit() {
    assertEquals(
        "compute with 349.5 m/s (air of 30 degrees), not 343.0",
        remedy(Effect.SOUND_SPEED, "scale", 349.5));
    assertEquals(
        "multiply readings by 2.540: that is a unit or a constant, not the air",
        remedy(Effect.SOUND_SPEED, "reading", 2.54 * 343));
  }

  @Test
  void numbers_areThoseOfTheFit() {
    assertEquals("add 0.9 cm to every reading", remedy(Effect.RANGE_OFFSET, "constant", -0.009));
    assertEquals("set cone_half_angle_deg to 17.5", remedy(Effect.BEAM_WIDTH, "cone", -2.5));
    assertEquals(
        "turn the sensor 3.0 degrees to the right", remedy(Effect.BEAM_MISALIGNMENT, "all", 3));
    assertEquals(
        "read 0.000 m as no echo, not as a distance",
        remedy(Effect.NO_ECHO_CODE, "near", 0, 1, 0.1));
  }

  /** In every form, without a number that is none. */
  @ParameterizedTest
  @MethodSource("simbad.sonar.effect.Definitions#effects")
  void everyForm_hasASentence(Effect effect) {
    for (Form form : Forms.all(Worlds.POST, List.of("s"))) {
      if (form.effect() == effect) {
        double[] values =
            form.parameters().stream().mapToDouble(p -> (p.low() + p.high()) / 2).toArray();
        String sentence = remedy(effect, form.name(), values);
        assertFalse(sentence.isEmpty() || sentence.contains("NaN"), form + ": " + sentence);
      }
    }
  }
}
