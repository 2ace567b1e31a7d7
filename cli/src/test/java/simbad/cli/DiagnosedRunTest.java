package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The robot driven in the world that a diagnosis found, from small models written by hand. */
class DiagnosedRunTest {
  private static final String TABLE =
      "bearing_deg,threshold_m\n0,0.5\n45,0.5\n90,0.5\n135,0.5\n180,0.5\n225,0.5\n270,0.5\n315,0.5\n";

  private static final String SCENE =
      """
      {
        "format": "sonar-gap/1",
        "no_echo_m": 6.5,
        "sensor": {
          "name": "by hand", "cone_half_angle_deg": 27.5, "min_range_m": 0.03, "max_range_m": 6,
          "mount_height_m": 0.05, "assumed_sound_speed_m_s": 343, "resolution_m": 0.01,
          "range_noise_m": 0, "miss_rate": 0, "edge_width_m": 0, "update_period_s": 0.05
        },
        "obstacles": [
          {"name": "round", "x_m": 0, "z_m": 0, "turn_deg": 0, "detection": "uniform",
           "uniform_range_m": 0.5, "outline_m": [[0.01, 0], [0, 0.01], [-0.01, 0], [0, -0.01]]},
          {"name": "plate", "x_m": 2, "z_m": 0, "turn_deg": 0, "detection": "uniform",
           "uniform_range_m": 0.5, "outline_m": [[0.01, 0], [0, 0.01], [-0.01, 0], [0, -0.01]]}
        ]
      }
      """;

  private static final String GAIN =
      "{\"effect\": \"gain\", \"form\": \"factor\", \"parameters\": {\"factor\": %s}}";

  private static final String TURN =
      "{\"effect\": \"obstacle-turn\", \"form\": \"only:plate\", \"parameters\": {\"turn_deg\": 5}}";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path diagnosis(String name, String... changes) throws IOException {
    Path diagnosis = Files.createDirectory(folder.resolve(name));
    Files.writeString(diagnosis.resolve("scene.json"), SCENE);
    Files.writeString(
        diagnosis.resolve("model.json"),
        "{\n\"format\": \"sonar-model/1\",\n\"sensors\": [\"s0\"],\n\"changes\": [\n"
            + String.join(",\n", changes)
            + "\n]\n}\n");
    return diagnosis;
  }

  private Shell run(String out, String sensors, String... more) throws IOException {
    Path table = folder.resolve("circle.csv");
    Files.writeString(table, TABLE);
    List<String> words = new ArrayList<>(List.of("run", table.toString(), "--speed", "0.05"));
    words.addAll(List.of("--sensor", sensors, "--out", folder.resolve(out).toString()));
    words.addAll(List.of(more));
    return Shell.simbad(words.toArray(String[]::new));
  }

  private static double ratio(String text) {
    Matcher matcher = Pattern.compile("at (\\d\\.\\d+) times its distance").matcher(text);
    assertTrue(matcher.find(), text);
    return Double.parseDouble(matcher.group(1));
  }

  @Test
  void gain_circlesAtItsShareOfTheTable() throws IOException {
    Path diagnosis = diagnosis("weak one", GAIN.formatted("0.8"));
    Shell shell = run("out", "shadow,diagnosed:" + diagnosis);
    assertEquals(0, shell.status(), shell.err());
    assertEquals(0.8, ratio(shell.out()), 0.011, shell.out());
    assertTrue(shell.out().contains("nearer than the shadow sensor's trace"), shell.out());
    assertTrue(shell.out().contains("8 of 8 bearings"), shell.out());
    // 20 % of 0.5 m, to a few steps of 2.5 mm.
    double error =
        new ObjectMapper()
            .readTree(folder.resolve("out/errors.json").toFile())
            .get("results")
            .get(1)
            .get("mean_abs_cm")
            .asDouble();
    assertEquals(10, error, 0.5);
    assertTrue(Files.exists(folder.resolve("out/circle/map-diagnosed-weak-one.svg")));
    String page = Files.readString(folder.resolve("out/report.html"));
    assertEquals(0.8, ratio(page), 0.011);
    assertTrue(page.contains("sensor by hand: gain/factor (factor 0.8000)"), page);
  }

  @Test
  void alone_isComparedWithTheTable() throws IOException {
    Shell shell = run("out", "diagnosed:" + diagnosis("d", GAIN.formatted("1.2")));
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("further out than the table"), shell.out());
    assertEquals(1.2, ratio(shell.out()), 0.015, shell.out());
  }

  /** Beside nothing that is believed, there are no parts of an error, and the run says why. */
  @Test
  void aloneOnARobot_itSaysWhyThereAreNoParts() throws IOException {
    Path robot = folder.resolve("tin.json");
    Files.writeString(robot, "{\"format\": \"motion-gap/1\", \"kinematics\": \"unicycle\"}");
    String sensor = "diagnosed:" + diagnosis("d", GAIN.formatted("1.2"));
    Shell alone = run("out", sensor, "--robot", robot.toString());
    assertEquals(0, alone.status(), alone.err());
    assertTrue(alone.out().contains("name a believed sensor beside"), alone.out());
    Shell both = run("both", "shadow," + sensor, "--robot", robot.toString());
    assertFalse(both.out().contains("name a believed sensor beside"), both.out());
  }

  @Test
  void changeOfAnotherObstacle_isSaidToBeIdle() throws IOException {
    Shell shell = run("out", "diagnosed:" + diagnosis("d", TURN));
    assertEquals(0, shell.status(), shell.err());
    assertEquals(1, ratio(shell.out()), 0.011, shell.out());
    String page = Files.readString(folder.resolve("out/report.html"));
    assertTrue(page.contains("obstacle-turn/only:plate belongs to an obstacle that is not"), page);
  }

  @Test
  void memoryAndNoise_sameSeed_sameTrace() throws IOException {
    Path diagnosis =
        diagnosis(
            "d",
            "{\"effect\": \"dropout\", \"form\": \"bursts\","
                + " \"parameters\": {\"share\": 0.1, \"length_pings\": 3}}",
            "{\"effect\": \"latency\", \"form\": \"time\", \"parameters\": {\"delay_s\": 0.1}}");
    assertEquals(0, run("one", "diagnosed:" + diagnosis).status());
    assertEquals(0, run("two", "diagnosed:" + diagnosis).status());
    for (String file : new String[] {"circle/trace.csv", "errors.json", "report.html"}) {
      assertArrayEquals(
          Files.readAllBytes(folder.resolve("one").resolve(file)),
          Files.readAllBytes(folder.resolve("two").resolve(file)),
          file);
    }
  }

  @Test
  void badModel_isNamedByFileLineAndField() throws IOException {
    Path diagnosis = diagnosis("d", GAIN.formatted("-2"));
    Shell shell = run("out", "diagnosed:" + diagnosis);
    assertEquals(2, shell.status());
    assertEquals(1, shell.complaints().size(), shell.err());
    String where = diagnosis.resolve("model.json") + ":5: changes.0.parameters.factor: ";
    assertTrue(shell.err().contains(where + "-2 is not a number in ["), shell.err());
    Files.delete(diagnosis.resolve("model.json"));
    Shell missing = run("out", "diagnosed:" + diagnosis);
    assertEquals(2, missing.status());
    assertTrue(missing.err().contains("model.json: no such file"), missing.err());
  }

  @Test
  void twoOfOneName_areRefused() throws IOException {
    Path diagnosis = diagnosis("d", GAIN.formatted("0.8"));
    Shell shell = run("out", "diagnosed:" + diagnosis + ",diagnosed:" + diagnosis);
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("appears twice"), shell.err());
  }
}
