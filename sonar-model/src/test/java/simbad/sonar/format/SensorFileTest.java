package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.scene.SonarSpec;

class SensorFileTest {
  @TempDir private Path directory = Path.of("target");

  private Path with(String field, String value) throws Exception {
    String sensor = Samples.sensor();
    String spoiled =
        sensor.replaceFirst(
            "\"" + field + "\": [^,\n]*", Matcher.quoteReplacement("\"" + field + "\": " + value));
    assertTrue(!spoiled.equals(sensor), field);
    return Faults.file(directory, spoiled);
  }

  @Test
  void sensor_isRead() throws Exception {
    SonarSpec sensor = SensorFile.read(Faults.file(directory, Samples.sensor()));
    assertEquals("srf04", sensor.name());
    assertEquals(Math.toRadians(27.5), sensor.coneHalfAngleRad());
    assertEquals(0.03, sensor.minRangeM());
    assertEquals(6, sensor.maxRangeM());
    assertEquals(0.05, sensor.mountHeightM());
    assertEquals(343, sensor.assumedSoundSpeedMPerS());
    assertEquals(0.01, sensor.resolutionM());
    assertEquals(0.005, sensor.rangeNoiseM());
    assertEquals(0.02, sensor.missRate());
    assertEquals(0.1, sensor.edgeWidthM());
    assertEquals(0.06, sensor.updatePeriodS());
  }

  /** What docs/method/sonar-model.md says of the default sensor's file. */
  @Test
  void defaultSensor_namesASourceForEachFigure() throws Exception {
    JsonInput sensor = JsonInput.read(Path.of("..", "data", "sensors", "srf04.json"));
    List<String> figures =
        sensor.names().stream()
            .filter(name -> name.matches(".*_(deg|m|m_s|rate|s)"))
            .sorted()
            .toList();
    assertEquals(figures, sensor.field("sources").names().stream().sorted().toList());
    assertEquals(10, figures.size());
  }

  @ParameterizedTest
  @CsvSource({
    "cone_half_angle_deg, 180",
    "min_range_m, 0",
    "resolution_m, 0",
    "range_noise_m, 0",
    "miss_rate, 0",
    "miss_rate, 1",
    "edge_width_m, 0",
    "mount_height_m, 0",
    "max_range_m, 1e6"
  })
  void figure_atTheEndOfItsDomain_isTaken(String field, String value) throws Exception {
    assertEquals("srf04", SensorFile.read(with(field, value)).name());
  }

  /** Field, value, its line in the file, what was expected. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "name | 5 | 2 | 5 is not a text",
        "cone_half_angle_deg | 0 | 3 | 0 is not an angle in (0, 180] degrees",
        "cone_half_angle_deg | 180.1 | 3 | 180.1 is not an angle in (0, 180] degrees",
        "cone_half_angle_deg | 1e-323 | 3 | is not an angle in (0, 180] degrees",
        "cone_half_angle_deg | \"27.5\" | 3 | \"27.5\" is not an angle",
        "min_range_m | -0.01 | 4 | -0.01 is not a number of at least 0",
        "max_range_m | 0.03 | 5 | 0.03 is not a range above min_range_m = 0.03",
        "max_range_m | 1e999 | 5 | is not a range above",
        "mount_height_m | -1 | 6 | -1 is not",
        "assumed_sound_speed_m_s | 0 | 7 | 0 is not a number above 0",
        "resolution_m | -1 | 8 | -1 is not",
        "range_noise_m | null | 9 | null is not",
        "miss_rate | 1.01 | 10 | 1.01 is not a share in [0, 1]",
        "edge_width_m | [1] | 11 | [1] is not",
        "update_period_s | 0 | 12 | 0 is not a number above 0"
      })
  void figure_outOfItsDomain_isRefused(String field, String value, int line, String part)
      throws Exception {
    Faults.check(SensorFile::read, with(field, value), ":" + line + ": " + field + ": ", part);
  }

  /** It is printed, drawn and written into other files' lines. */
  @ParameterizedTest
  @ValueSource(strings = {"a\\nb", "\\u001b[2J", "\\u2028"})
  void nameOnTwoLines_isRefused(String name) throws Exception {
    Faults.check(SensorFile::read, with("name", '"' + name + '"'), ":2: name: ", "on one line");
  }

  @Test
  void longName_isRefused() throws Exception {
    SensorFile.read(with("name", '"' + "n".repeat(200) + '"'));
    Faults.check(
        SensorFile::read,
        with("name", '"' + "n".repeat(201) + '"'),
        ":2: name: ",
        "is not a name of at most 200 characters");
    Faults.check(
        SensorFile::read,
        with("name", '"' + "n".repeat(5_000_000) + '"'),
        ":2: name: ",
        "5000000 characters");
  }

  @Test
  void anotherFile_isRefused() throws Exception {
    Faults.check(
        SensorFile::read, Faults.file(directory, Samples.scene()), ":1: cone_half_angle_deg: ");
    Faults.check(SensorFile::read, Faults.file(directory, Samples.TABLE), ":1: JSON: ");
  }
}
