package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelFigures;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.StrengthDetection;

/** Scenes of format 2, as far as the level model needs them. */
class LevelFieldsTest {
  private static final String LEVEL =
      """
      "model": "level",
          "level": {
            "frequency_hz": 40000,
            "spreading_exponent": 1.5,
            "absorption_db_per_m": 1.25,
            "temperature_c": 7.5,
            "humidity_percent": 80,
            "beam": {"aperture_radius_m": 0.0072},
            "receiver_threshold_db": [[0, 28], [1, 4.5], [2.5, 0]],
            "excess_sd_db": 0.8,
            "walk_m": [[0, 0.03], [20, 0]],
            "noise_m": [[0, 0.006]],
            "pulse_length_s": 0.0002,
            "level_db": 33,
            "source": "a bench"
          },
      """;

  @TempDir private Path directory = Path.of("target");

  /** The sample scene as one of format 2 that believes the level model. */
  private static String scene() throws Exception {
    return Samples.scene()
        .replace("sonar-gap/1", "sonar-gap/2")
        .replace("\"cone_half_angle_deg\"", LEVEL + "\"cone_half_angle_deg\"")
        .replace("\"uniform\"", "\"strength\"")
        .replace("\"uniform_range_m\": 2", "\"strength_db\": [-10, -20.5, 0]");
  }

  private SensingSetup read(String text) throws Exception {
    return SceneFile.read(Faults.file(directory, text));
  }

  @Test
  void law_isRead() throws Exception {
    SensorLaw law = read(scene()).sensor().law();
    assertEquals(Optional.of(SensorLaw.Model.LEVEL), law.model());
    assertTrue(law.isLevel());
    LevelFigures level = law.level();
    assertEquals(40_000, level.frequencyHz().getAsDouble());
    assertEquals(1.5, level.spreadingExponent().getAsDouble());
    assertEquals(1.25, level.absorptionDbPerM().getAsDouble());
    assertEquals(7.5, level.temperatureC().getAsDouble());
    assertEquals(80, level.humidityPercent().getAsDouble());
    assertEquals(0.0072, level.apertureRadiusM().getAsDouble());
    assertEquals(Optional.of(Curve.of(0, 28, 1, 4.5, 2.5, 0)), level.receiverThresholdDb());
    assertEquals(0.8, level.excessSdDb().getAsDouble());
    assertEquals(Optional.of(Curve.of(0, 0.03, 20, 0)), level.walkM());
    assertEquals(Optional.of(Curve.constant(0.006)), level.noiseM());
    assertEquals(0.0002, level.pulseLengthS().getAsDouble());
    assertEquals(33, level.levelDb().getAsDouble());
    assertEquals(List.of(), level.missing());
  }

  @Test
  void strengths_areRead() throws Exception {
    StrengthDetection detection =
        (StrengthDetection) read(scene()).scene().obstacles().get(1).detection();
    assertEquals(StrengthTable.of(-10, -20.5, 0), detection.strength());
    assertEquals(72, detection.thresholds().size());
  }

  @Test
  void scene_comesBack() throws Exception {
    SensingSetup setup = read(scene());
    String text = SceneWriter.text(setup);
    assertTrue(text.contains("\"format\" : \"sonar-gap/2\""), text);
    SensingSetup again = read(text);
    assertEquals(setup, again);
    assertEquals(text, SceneWriter.text(again));
  }

  @Test
  void beamAsACurve_comesBack() throws Exception {
    String scene =
        scene().replace("\"aperture_radius_m\": 0.0072", "\"two_way_db\": [[0, 0], [30, -12.5]]");
    SensingSetup setup = read(scene);
    assertEquals(Optional.of(Curve.of(0, 0, 30, -12.5)), setup.sensor().law().level().twoWayDb());
    assertEquals(setup, read(SceneWriter.text(setup)));
  }

  @Test
  void everything_mayBeLeftOut() throws Exception {
    String scene = Samples.scene().replace("sonar-gap/1", "sonar-gap/2");
    assertEquals(SensorLaw.UNSTATED, read(scene).sensor().law());
    String empty =
        scene.replace("\"cone_half", "\"level\": {}, \"model\": \"threshold\", \"cone_half");
    SensorLaw law = read(empty).sensor().law();
    assertEquals(Optional.of(SensorLaw.Model.THRESHOLD), law.model());
    assertFalse(law.isLevel());
    assertEquals(LevelFigures.NONE, law.level());
    assertTrue(SceneWriter.text(read(empty)).contains("\"model\" : \"threshold\""));
  }

  /** What is of format 1 stays as it was, whatever stands beside its fields. */
  @Test
  void format1_knowsNoLevel() throws Exception {
    String scene = scene().replace("sonar-gap/2", "sonar-gap/1");
    Faults.check(
        SceneFile::read,
        Faults.file(directory, scene),
        ":49: obstacles.1.detection: ",
        "\"strength\" is not \"table\" or \"uniform\"");
    SensingSetup plain = read(Samples.scene());
    String beside = Samples.scene().replace("\"cone_half", LEVEL + "\"cone_half");
    assertEquals(plain, read(beside));
    assertEquals(SceneWriter.text(plain), SceneWriter.text(read(beside)));
  }

  /** A sensor's own file tells how it hears; a scene of format 1 that is made with it does not. */
  @Test
  void sensorFile_hasTheLevelAndBelievesNoModel() throws Exception {
    String sensor = Samples.sensor().replace("\"cone_half", LEVEL + "\"cone_half");
    SonarSpec spec = SensorFile.read(Faults.file(directory, sensor));
    assertEquals(33, spec.law().level().levelDb().getAsDouble());
    assertEquals(Optional.empty(), spec.law().model());
    SensingSetup setup = new SensingSetup(spec, read(Samples.scene()).scene(), 6.5);
    assertEquals(
        SceneWriter.text(read(Samples.scene())), SceneWriter.text(setup), "of the first format");
  }

  /** A piece of the scene, what is put in its place, where the fault is named, and how. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"model\": \"level\" | \"model\": \"physics\" | 6: sensor.model | \"physics\" is not \"threshold\" or \"level\"",
        "\"model\": \"level\" | \"model\": true | 6: sensor.model | true is not \"threshold\"",
        "\"frequency_hz\": 40000 | \"frequency_hz\": 40 | 8: sensor.level.frequency_hz | 40 is not a frequency in",
        "\"frequency_hz\": 40000 | \"freqency_hz\": 40000 | 8: sensor.level.freqency_hz | is not a field here, expected some of frequency_hz, spreading_exponent",
        "\"spreading_exponent\": 1.5 | \"spreading_exponent\": -1 | 9: sensor.level.spreading_exponent | -1 is not a number in [0, 10]",
        "\"absorption_db_per_m\": 1.25 | \"absorption_db_per_m\": \"1\" | 10: sensor.level.absorption_db_per_m | \"1\" is not a number in [0, 100]",
        "\"temperature_c\": 7.5 | \"temperature_c\": 293 | 11: sensor.level.temperature_c | 293 is not a temperature in [-40, 60]",
        "\"humidity_percent\": 80 | \"humidity_percent\": 101 | 12: sensor.level.humidity_percent | 101 is not a share",
        "{\"aperture_radius_m\": 0.0072} | {\"aperture_radius_m\": 7.2} | 13: sensor.level.beam.aperture_radius_m | 7.2 is not a radius in",
        "{\"aperture_radius_m\": 0.0072} | {} | 13: sensor.level.beam | has neither, expected either aperture_radius_m or two_way_db",
        "{\"aperture_radius_m\": 0.0072} | {\"aperture_radius_m\": 0.0072, \"two_way_db\": [[0, 0]]} | 13: sensor.level.beam | has both",
        "{\"aperture_radius_m\": 0.0072} | {\"radius\": 1} | 13: sensor.level.beam.radius | is not a field here",
        "{\"aperture_radius_m\": 0.0072} | {\"two_way_db\": [[190, 0]]} | 13: sensor.level.beam.two_way_db.0.0 | 190 is not an angle",
        "{\"aperture_radius_m\": 0.0072} | 0.0072 | 13: sensor.level.beam | is not an object",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [] | 14: sensor.level.receiver_threshold_db | 0 numbers",
        "[[0, 28], [1, 4.5], [2.5, 0]] | 3 | 14: sensor.level.receiver_threshold_db | 3 is not a list",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [[0, 28], [0, 4]] | 14: sensor.level.receiver_threshold_db | x = 0.0 does not rise from 0.0",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [[0, 28, 3]] | 14: sensor.level.receiver_threshold_db.0 | [0,28,3] is not a pair [x, y] of a curve",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [28] | 14: sensor.level.receiver_threshold_db.0 | 28 is not a pair",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [[-1, 28]] | 14: sensor.level.receiver_threshold_db.0.0 | -1 is not a distance",
        "[[0, 28], [1, 4.5], [2.5, 0]] | [[0, null]] | 14: sensor.level.receiver_threshold_db.0.1 | null is not a level",
        "\"excess_sd_db\": 0.8 | \"excess_sd_db\": -0.8 | 15: sensor.level.excess_sd_db | -0.8 is not a number in",
        "\"walk_m\": [[0, 0.03] | \"walk_m\": [[0, 30] | 16: sensor.level.walk_m.0.1 | 30 is not a length in [-10, 10] m",
        "\"noise_m\": [[0, 0.006]] | \"noise_m\": [[0, -0.1]] | 17: sensor.level.noise_m.0.1 | -0.1 is not a length in [0, 10] m",
        "\"pulse_length_s\": 0.0002 | \"pulse_length_s\": 200 | 18: sensor.level.pulse_length_s | 200 is not a time",
        "\"level_db\": 33 | \"level_db\": 1e999 | 19: sensor.level.level_db | is not a level in",
        "\"strength\" | \"echo\" | 49: obstacles.1.detection | \"echo\" is not \"table\", \"uniform\" or \"strength\"",
        "[-10, -20.5, 0] | [] | 50: obstacles.1.strength_db | is empty, expected at least 1 value",
        "[-10, -20.5, 0] | -10 | 50: obstacles.1.strength_db | -10 is not a list",
        "[-10, -20.5, 0] | [-10, -400] | 50: obstacles.1.strength_db.1 | -400 is not a level in [-300, 300] dB",
        "\"strength_db\" | \"strengths\" | 43: obstacles.1.strength_db | is missing"
      })
  void field_spoiled_isNamed(String piece, String instead, String where, String part)
      throws Exception {
    String scene = scene();
    assertTrue(scene.contains(piece), piece);
    int at = scene.indexOf(piece);
    String spoiled = scene.substring(0, at) + instead + scene.substring(at + piece.length());
    Faults.check(SceneFile::read, Faults.file(directory, spoiled), ":" + where + ": ", part);
  }
}
