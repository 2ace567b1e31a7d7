package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.DataFormatException;

/** What a spec may not say; each message names the file, the line and the field. */
class BatchSpecTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private String complaint(String text) throws Exception {
    Files.writeString(folder.resolve("small.csv"), Specs.TABLE);
    Path spec = folder.resolve("spec.json");
    DataFormatException fault =
        assertThrows(
            DataFormatException.class,
            () -> BatchJob.read(spec, text.replace('\'', '"').replace(";", "\n")));
    return String.valueOf(fault.getMessage()).replace(folder + "/", "");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          {}|spec.json:1: format: is missing
          {'format': 'simbad-batch/2'}|spec.json:1: format: "simbad-batch/2" is not "simbad-batch/1"
          {'format': 'simbad-batch/1'}|spec.json:1: JSON: neither obstacles nor scenes, expected at least one
          {'format': 'simbad-batch/1', 'obstacles': 3}|spec.json:1: obstacles: 3 is not a list
          """)
  void wholeSpec_isRefused(String text, String message) throws Exception {
    assertEquals(message, complaint(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          'sensor': ['shadow']|sensor: is not a field here, expected one of format, obstacles, scenes, sensors, robots, sensor_files, effects, controllers, speeds_m_per_s, turn_rate_rad_per_s, wait_s, seeds, sample, traces
          'seeds': []|seeds: is empty, expected at least one
          'sensors': []|sensors: is empty, expected at least one
          'effects': []|effects: is empty, expected at least one
          'seeds': [1, 2, 1]|seeds.2: 1 appears twice
          'seeds': [1.5]|seeds.0: 1.5 is not a whole number of 64 bits
          'seeds': {'from': 1}|seeds.count: is missing
          'seeds': {'from': 1, 'count': 0}|seeds.count: 0 is not a whole number of at least 1
          'seeds': {'from': 2, 'count': 9223372036854775807}|seeds.count: the last seed is beyond 64 bits
          'seeds': {'from': 1, 'count': 2, 'step': 2}|seeds.step: is not a field here, expected one of from, count
          'speeds_m_per_s': [0]|speeds_m_per_s.0: 0 is not a speed in (0, 1.0] m/s
          'speeds_m_per_s': [0.1, 0.1]|speeds_m_per_s.1: 0.1 appears twice
          'sensors': ['sonar']|sensors.0: "sonar" is not one of original, ray, shadow, overlap, noisy, level, level-noisy, diagnosed:DIR
          'sensors': ['diagnosed:']|sensors.0: "diagnosed:" is not the name of a file or folder
          'controllers': [{'parameters': {}}]|controllers.0.name: is missing
          'controllers': [{'name': 'x'}]|controllers.0.name: "x" is not the name of a controller: edge-follower, moody
          'controllers': [{'name': 'moody', 'parameters': {'mod': 1}}]|controllers.0.parameters.mod: is not a field here, expected one of mood
          'controllers': [{'name': 'moody', 'parameters': {'mood': 4}}]|controllers.0.parameters.mood: 4 is not a number in [0.0, 3.0]
          'controllers': [{'name': 'moody', 'parameters': {'mood': [1, 1]}}]|controllers.0.parameters.mood.1: 1.0 appears twice
          'sensors': ['noisy'], 'effects': [[{'effect': 'gain'}]]|effects.0.0.form: is missing
          'sensors': ['noisy'], 'effects': [[{'effect': 'gain', 'form': 'factor', 'parameters': {'factor': 9}}]]|effects.0.0.parameters.factor: 9 is not a number in [0.2, 3.0]
          'sensors': ['ray'], 'effects': [[{'effect': 'dropout', 'form': 'single', 'parameters': {'share': 0.1}}]]|sensors.0: effects act on the nominal model, so on the sensors shadow and noisy only
          'robots': []|robots: is empty, expected at least one
          'robots': ['diagnosed:']|robots.0: "diagnosed:" is not the name of a file or folder
          'turn_rate_rad_per_s': 0|turn_rate_rad_per_s: 0 is not in [0.001, 2 pi] rad/s
          'wait_s': 6|wait_s: 6 is not in [0, 5.0] s
          'traces': 1|traces: 1 is not true or false
          'obstacles': ['square', '']|obstacles.1: "" is not the name of a file or folder
          'sample': {'runs': 1}|sample.seed: is missing
          """)
  void field_isRefused(String field, String message) throws Exception {
    String obstacles = field.contains("'obstacles'") ? "" : "'obstacles': ['small.csv'],;";
    assertEquals(
        "spec.json:" + (obstacles.isEmpty() ? 2 : 3) + ": " + message,
        complaint("{'format': 'simbad-batch/1',;" + obstacles + field + "}"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          'seeds': {'from': 1, 'count': 1000000000}|1000000000 runs, expected at most 10000000; "sample" takes some of them
          'seeds': {'from': 1, 'count': 4000000000000000000}, 'speeds_m_per_s': [0.1, 0.2, 0.3]|12000000000000000000 runs, expected at most 10000000; "sample" takes some of them
          'seeds': {'from': 1, 'count': 4000000000000000000}, 'speeds_m_per_s': [0.1, 0.2, 0.3], 'sample': {'runs': 2, 'seed': 1}|12000000000000000000 runs to take a sample of, expected at most 2^62
          'sample': {'runs': 2, 'seed': 1}|a sample of 2 runs, expected at most 1
          'seeds': {'from': 1, 'count': 1000000000}, 'sample': {'runs': 10000001, 'seed': 1}|a sample of 10000001 runs, expected at most 10000000
          """)
  void product_isRefused(String field, String message) throws Exception {
    String spec =
        "{'format': 'simbad-batch/1', 'sensors': ['shadow'], 'obstacles': ['small.csv'], ";
    assertEquals("spec.json: " + message, complaint(spec + field + "}"));
  }

  @Test
  void missingAndEqualFiles_areNamed() throws Exception {
    String head = "{'format': 'simbad-batch/1', 'obstacles': ";
    assertEquals(
        "spec.json:1: obstacles.0: \"gone.csv\" is not one of square, round, angle, half-round,"
            + " hexagon, plate, tee, channel, leg-pair, a table (*.csv), or a folder with outline"
            + " and table; there is no gone.csv",
        complaint(head + "['gone.csv']}"));
    assertEquals(
        "spec.json: two of its obstacles or scenes are called small",
        complaint(head + "['small.csv', './small.csv']}"));
    assertEquals(
        "gone.json: no such file", complaint(head + "['square'], 'scenes': ['gone.json']}"));
    assertEquals(
        "spec.json: no such file", complaint(head + "['square'], 'sensor_files': ['spec.json']}"));
  }
}
