package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Placement;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** A corrected scene reads by itself what the stated one reads with what was fitted. */
class CorrectedSceneTest {
  private static final List<String> SENSORS = List.of("s0");

  private static Form form(SensingSetup setup, String effect, String form) {
    return Forms.find(Definitions.find(effect).orElseThrow(), form, setup, SENSORS).orElseThrow();
  }

  private static Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... v) {
    return Definitions.of(form.effect()).corrected(stated, form, v);
  }

  private static void assertSame(
      List<ReadingDistribution> expected, List<ReadingDistribution> found, double mostM) {
    for (int ping = 0; ping < expected.size(); ping++) {
      String where = "ping " + ping;
      ReadingDistribution fitted = expected.get(ping);
      ReadingDistribution stated = found.get(ping);
      assertEquals(fitted.noEchoProbability(), stated.noEchoProbability(), 1e-9, where);
      for (double range = 0.003; range < mostM; range += 0.0317) {
        assertEquals(fitted.echoUpTo(range), stated.echoUpTo(range), 1e-9, where + " to " + range);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "two, obstacle-turn, all, 7.5, ",
    "two, obstacle-offset, all, 0.05, -0.02",
    "two, beam-width, cone, 6, ",
    "two, gain, factor, 0.8, ",
    "uniform, gain, factor, 1.2, ",
    "table36-turned, gain, factor, 0.7, ",
    "two, early-timeout, sharp, 1.4, ",
    "two, range-noise, constant, 0.02, ",
    "p000, dropout, single, 0.3, ",
    "two, coarse-resolution, start, 0.05, "
  })
  void correctedScene_readsWhatTheEffectDoes(
      String golden, String effect, String name, double first, Double second)
      throws DataFormatException {
    SensingSetup stated = Logs.setup(golden);
    Form form = form(stated, effect, name);
    double[] values = second == null ? new double[] {first} : new double[] {first, second};
    SensingSetup corrected = corrected(stated, form, values).orElseThrow();
    List<ReadingRow> rows = Logs.rows(golden, stated, new Random(5));
    List<ReadingDistribution> expected = Logs.forecast(stated, rows, List.of(form.with(values)));
    assertSame(expected, Logs.forecast(corrected, rows, List.of()), stated.sensor().maxRangeM());
  }

  /**
   * A mount that is turned is turned in the scene; where the sensor's own pose is read, nothing.
   */
  @Test
  void misalignedSensor_isMountedSo() throws DataFormatException {
    SensingSetup bare = Logs.setup("two");
    Form one =
        Forms.find(Effect.BEAM_MISALIGNMENT, "only:left", bare, List.of("left", "right"))
            .orElseThrow();
    assertEquals(Optional.empty(), corrected(bare, one, 6));
    Map<String, Placement> mounts =
        Map.of("left", new Placement(0.1, 0, 1), "right", new Placement(0.1, 0, -1));
    SensingSetup stated = bare.with(bare.details().mounted(mounts));
    Map<String, Placement> only =
        corrected(stated, one, 6).orElseThrow().details().robotFromSensor();
    assertEquals(1 + Math.toRadians(6), turn(only, "left"), 1e-12);
    assertEquals(-1, turn(only, "right"));
    Form all = form(stated, "beam-misalignment", "all");
    Map<String, Placement> both =
        corrected(stated, all, -3).orElseThrow().details().robotFromSensor();
    assertEquals(-1 - Math.toRadians(3), turn(both, "right"), 1e-12);
  }

  private static double turn(Map<String, Placement> mounts, String sensor) {
    return mounts.getOrDefault(sensor, Placement.IDENTITY).turnRad();
  }

  @Test
  void shadowOfAUniformObstacle_becomesItsTable() throws DataFormatException {
    SensingSetup stated = Logs.setup("uniform");
    Form table =
        Forms.of(Definitions.of(Effect.ORIENTATION_SHADOW), stated, SENSORS).stream()
            .filter(Form::isTable)
            .findFirst()
            .orElseThrow();
    double[] values = new double[table.parameters().size()];
    Arrays.setAll(values, i -> 1 + 0.02 * i);
    SensingSetup corrected = corrected(stated, table, values).orElseThrow();
    assertTrue(
        corrected.scene().obstacles().stream()
            .anyMatch(o -> o.detection().findTable().isPresent()));
    List<ReadingRow> rows = Logs.rows("uniform", stated, new Random(5));
    assertSame(
        Logs.forecast(stated, rows, List.of(table.with(values))),
        Logs.forecast(corrected, rows, List.of()),
        stated.sensor().maxRangeM());
  }

  @Test
  void soundOfAir_isTheSensorsAndAWrongUnitIsNot() throws DataFormatException {
    SensingSetup stated = Logs.setup("two");
    Form scale = form(stated, "sound-speed", "scale");
    assertEquals(
        349, corrected(stated, scale, 349).orElseThrow().sensor().assumedSoundSpeedMPerS());
    assertTrue(corrected(stated, scale, 871.2).isEmpty());
  }

  @Test
  void post_isPutIntoTheScene() throws DataFormatException {
    SensingSetup stated = Logs.setup("two");
    Form post = form(stated, "unmodelled-object", "post");
    SensingSetup corrected = corrected(stated, post, 3, -2, 0.05, 1.5, 1, 90).orElseThrow();
    var found = corrected.scene().obstacles().get(2);
    assertEquals(3, found.worldFromObstacle().xM());
    assertEquals(-2, found.worldFromObstacle().zM());
    assertEquals(0.05, found.outline().reachM(0, 0), 1e-12);
    assertEquals(1.55, found.detection().greatestM(), 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"latency, 0.2", "range-offset, 0.03", "previous-ping, 0.2", "heading-drift, 0.5"})
  void whatNoFieldSays_hasNoPlace(String effect, double value) throws DataFormatException {
    SensingSetup stated = Logs.setup("two");
    Form form =
        Forms.of(Definitions.of(Definitions.find(effect).orElseThrow()), stated, SENSORS).get(0);
    double[] values = form.neutral();
    values[0] = value;
    assertTrue(corrected(stated, form, values).isEmpty());
  }

  @Test
  void timeoutNearerThanTheSensorHears_hasNoPlace() throws DataFormatException {
    SensingSetup two = Logs.setup("two");
    SensingSetup deaf = two.with(two.sensor().withRange(0.5, two.sensor().maxRangeM()));
    assertTrue(corrected(deaf, form(deaf, "early-timeout", "sharp"), 0.3).isEmpty());
  }
}
