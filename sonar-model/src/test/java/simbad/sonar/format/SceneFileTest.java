package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

class SceneFileTest {
  private static final SonarSpec SRF04 =
      new SonarSpec(
          "srf04", Math.toRadians(27.5), 0.03, 6, 0.05, 343, 0.01, 0.005, 0.02, 0.1, 0.06);

  @TempDir private Path directory = Path.of("target");

  private void check(String text, String where, String... parts) throws Exception {
    Faults.check(SceneFile::read, Faults.file(directory, text), where, parts);
  }

  @Test
  void scene_isRead() throws Exception {
    SensingSetup setup = SceneFile.read(Faults.file(directory, Samples.scene()));
    assertEquals(SRF04, setup.sensor());
    assertEquals(6.5, setup.noEchoM());
    assertEquals(2, setup.scene().obstacles().size());
    assertEquals(
        new Obstacle(
            "post",
            new Placement(1.5, -0.5, Math.PI / 2),
            Shapes.outline(0, 0, 0.1, 0, 0, 0.2),
            new TableDetection(ThresholdTable.of(1, 2, 3, 0))),
        setup.scene().obstacles().get(0));
    assertEquals(new UniformDetection(2), setup.scene().obstacles().get(1).detection());
  }

  @Test
  void obstacleName_thatIsTooLong_isRefused() throws Exception {
    check(
        Samples.scene().replace("\"post\"", '"' + "n".repeat(70_000) + '"'),
        ":",
        "obstacles.0.name: ",
        "expected at most 10000");
  }

  /** Names of ROS have slashes; a tilde is the other sign that a JSON pointer needs itself. */
  @Test
  void faultBelowANameWithSlashes_isNamedWithItsLine() throws Exception {
    String scene =
        Samples.scene()
            .replace("sonar-gap/1", "sonar-gap/2")
            .replace(
                "\"no_echo_m\": 6.5,",
                "\"no_echo_m\": 6.5, \"sensors\": {\n\"/us~left\": {\"x_m\": \"a\"}},");
    check(scene, ":4:", "sensors./us~left.x_m", "\"a\" is not");
  }

  @Test
  void scene_isRead_howeverItIsWritten() throws Exception {
    SensingSetup setup = SceneFile.read(Faults.file(directory, Samples.scene()));
    String crlf = "\uFEFF" + Samples.scene().replace("\n", "\r\n") + "\r\n\r\n";
    assertEquals(setup, SceneFile.read(Faults.file(directory, crlf)));
    String oneLine = Samples.scene().replace("\n", "").replace(" ", "");
    assertEquals(setup, SceneFile.read(Faults.file(directory, oneLine)));
    String more = Samples.scene().replace("\"x_m\": 0,", "\"x_m\": 0, \"colour\": [null, {}],");
    assertEquals(setup, SceneFile.read(Faults.file(directory, more)));
    String empty = Samples.scene().replaceAll("(?s)\"obstacles\": \\[.*\\]", "\"obstacles\": []");
    assertTrue(SceneFile.read(Faults.file(directory, empty)).scene().obstacles().isEmpty());
  }

  /** A piece of the scene, what is put in its place (. for nothing), where the fault is named. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "sonar-gap/1 | sonar-gap/3 | 2: format | \"sonar-gap/3\" is not \"sonar-gap/1\" or \"sonar-gap/2\"",
        "\"format\": \"sonar-gap/1\", | . | 1: format | is missing",
        "\"no_echo_m\": 6.5, | . | 1: no_echo_m | is missing",
        "\"no_echo_m\": 6.5 | \"no_echo_m\": 0 | 3: no_echo_m | 0 is not a number above 0",
        "\"x_m\": 1.5, | . | 18: obstacles.0.x_m | is missing",
        "\"x_m\": 1.5 | \"x_m\": \"1.5\" | 20: obstacles.0.x_m | \"1.5\" is not a finite number",
        "\"x_m\": 1.5 | \"x_m\": null | 20: obstacles.0.x_m | null is not a finite number",
        "\"x_m\": 1.5 | \"x_m\": [1.5] | 20: obstacles.0.x_m | is not a finite number",
        "\"x_m\": 1.5 | \"x_m\": 1e999 | 20: obstacles.0.x_m | is not a finite number",
        "\"x_m\": 1.5 | \"x_m\": NaN | 20: JSON | NaN",
        "\"x_m\": 1.5 | \"x_m\": 1,5 | 20: JSON | expecting",
        "\"x_m\": 1.5 | \"x_m\": 1.5, \"x_m\": 2 | 20: JSON | Duplicate field 'x_m'",
        "\"x_m\": 1.5, | \"x_m\": 1.5 | 21: JSON | expecting comma",
        "\"name\": \"post\" | \"name\": 5 | 19: obstacles.0.name | 5 is not a text",
        "\"turn_deg\": 0 | \"turn_deg\": true | 31: obstacles.1.turn_deg | true is not",
        "[1, 1], [-1, 1], [0, -1] | [1, 1], [-1, 1] | 32: obstacles.1.outline_m | 2 points",
        "[1, 1], [-1, 1], [0, -1] | [1, 1], [1, 1], [1, 1] | 32: obstacles.1.outline_m | all lie",
        "[1, 1], [-1, 1], [0, -1] | [0, 0], [1, 1], [1, 0], [0, 1] | 32: obstacles.1.outline_m "
            + "| the outline crosses itself: its edges from corner 1 and from corner 3",
        "[1, 1], [-1, 1], [0, -1] | [9, 9], [-9, 9], [0, -9] | 32: obstacles.1.outline_m "
            + "| overlaps obstacle post",
        "[1, 1], [-1, 1] | [1, 1], [-1] | 32: obstacles.1.outline_m.1 | [-1] is not a point [x, z]",
        "[1, 1], [-1, 1] | [1, 1], [-1, 1, 2] | 32: obstacles.1.outline_m.1 | [-1,1,2] is not a"
            + " point",
        "[1, 1], [-1, 1] | [1, 1], [-1, \"1\"] | 32: obstacles.1.outline_m.1.1 | \"1\" is not",
        "[1, 1], [-1, 1] | [1, 1], 7 | 32: obstacles.1.outline_m.1 | 7 is not a list",
        "\"table\" | \"mesh\" | 24: obstacles.0.detection | \"mesh\" is not \"table\" or"
            + " \"uniform\"",
        "\"detection\": \"uniform\", | . | 27: obstacles.1.detection | is missing",
        "\"thresholds_m\": [1, 2, 3, 0] | \"a\": 1 | 18: obstacles.0.thresholds_m | is missing",
        "[1, 2, 3, 0] | [1, 2] | 25: obstacles.0.thresholds_m | 2 values, expected at least 3",
        "[1, 2, 3, 0] | 7 | 25: obstacles.0.thresholds_m | is not a list",
        "[1, 2, 3, 0] | [1, 2, -3] | 25: obstacles.0.thresholds_m.2 | -3 is not a distance in",
        "[1, 2, 3, 0] | [1, 2000] | 25: obstacles.0.thresholds_m | 2 values",
        "[1, 2, 3, 0] | [1, 2000, 1] | 25: obstacles.0.thresholds_m.1 | 2000 is not a distance",
        "\"uniform_range_m\": 2 | \"uniform_range_m\": 1e9 | 34: obstacles.1.uniform_range_m | is"
            + " not",
        "\"uniform_range_m\": 2 | \"b\": 2 | 27: obstacles.1.uniform_range_m | is missing",
        "\"miss_rate\": 0.02 | \"miss_rate\": 2 | 13: sensor.miss_rate | 2 is not a share in [0,"
            + " 1]",
        "\"sensor\": { | \"sensor\": 5, \"s\": { | 4: sensor | is not an object",
        "\"obstacles\": [ | \"obstacles\": 5, \"o\": [ | 17: obstacles | is not a list",
        "\"obstacles\": [ | \"obstacles\": [7, | 17: obstacles.0 | is not an object"
      })
  void field_spoiled_isNamed(String piece, String instead, String where, String part)
      throws Exception {
    String scene = Samples.scene();
    assertTrue(scene.contains(piece), piece);
    int at = scene.indexOf(piece);
    String spoiled =
        scene.substring(0, at)
            + (instead.equals(".") ? "" : instead)
            + scene.substring(at + piece.length());
    check(spoiled, ":" + where + ": ", part);
  }

  @Test
  void everyFieldOfTheSensor_isNeeded() throws Exception {
    for (String line : Samples.sensor().lines().toList()) {
      if (line.contains("\"update_period_s\"") || !line.contains(":")) {
        continue;
      }
      String name = line.substring(line.indexOf('"') + 1, line.indexOf("\":"));
      check(
          Samples.scene().replaceFirst("\"" + name, "\"x"), ":4: sensor." + name + ": ", "missing");
    }
  }

  @Test
  void file_cutAnywhere_isRefused() throws Exception {
    String scene = Samples.scene().stripTrailing();
    for (int length = 0; length < scene.length(); length += 7) {
      check(scene.substring(0, length), ":");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " \n", "\uFEFF"})
  void emptyFile_isRefused(String text) throws Exception {
    check(text, ": ", "is empty");
  }

  @ParameterizedTest
  @ValueSource(strings = {"[]", "5", "null", "\"scene\"", "true"})
  void anotherKindOfJson_isRefused(String text) throws Exception {
    check(text, ":1: JSON: ", "is not an object");
  }

  @Test
  void textAfterTheEnd_isRefused() throws Exception {
    check(Samples.scene() + "x", ":38: JSON: ");
    check(Samples.scene() + "{}", ":38: JSON: ");
    check(Samples.scene() + "5", ":38: JSON: ");
  }

  @Test
  void deepNesting_isRefused() throws Exception {
    check("[".repeat(100_000), ":1: JSON: ", "nesting");
  }

  @Test
  void notAFile() {
    Faults.check(SceneFile::read, directory, ": ", "is a folder");
    Faults.check(SceneFile::read, directory.resolve("none.json"), ": ", "no such file");
  }
}
