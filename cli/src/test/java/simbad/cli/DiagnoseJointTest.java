package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A joint log whose origin is joint/make.py: a robot's wheels are 5 % larger than it believes. */
class DiagnoseJointTest {
  private static final Path LOGS = Path.of("..", "data", "joint");
  private static final Path LOG = LOGS.resolve("wheels-too-large");
  private static final double LARGER = 1.05;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Shell said;

  @BeforeAll
  static void diagnose() {
    said = Shell.simbad("diagnose", LOG.toString(), "--out", folder.toString());
    assertEquals(0, said.status(), said.err());
  }

  private static Path out() {
    return folder.resolve("wheels-too-large");
  }

  private static JsonNode json(String file) throws IOException {
    return new ObjectMapper().readTree(out().resolve(file).toFile());
  }

  @Test
  void theLine_namesTheCauseOnce() {
    assertTrue(
        said.out().startsWith("wheels-too-large: explained, wheel-scale; wheel-scale is one cause"),
        said.out());
  }

  @Test
  void diagnosis_fitsTheSchema_withBothHalves() throws IOException {
    JsonNode json = json("diagnosis.json");
    String schema = Files.readString(Path.of("..", "docs", "schema", "diagnosis.schema.json"));
    assertEquals(
        Set.of(),
        JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
            .getSchema(schema)
            .validate(json));
    assertEquals("joint", json.get("about").asText());
    assertEquals(1, json.get("explanation").size());
    JsonNode shared = json.at("/shared/0");
    assertTrue(shared.get("one_cause").asBoolean());
    for (String who : List.of("tracker", "sonar", "together")) {
      assertEquals(LARGER, shared.at("/" + who + "/value").asDouble(), 0.001, who);
    }
    assertEquals(47, json.get("effects").size());
    assertTrue(json.at("/gap/shrink").asDouble() > 0.8, json.get("gap").toString());
    assertTrue(json.at("/motion/gap/shrink").asDouble() > 0.5, json.get("motion").toString());
  }

  @Test
  void thePage_saysBothHalves() throws IOException {
    String page = Files.readString(out().resolve("report.html"));
    for (String part : List.of("One cause, one value", "The readings", "The motion")) {
      assertTrue(page.contains(part), part);
    }
    assertTrue(page.length() < 300_000, "page of " + page.length());
  }

  @Test
  void bothHalves_arePredicted() throws IOException {
    Path rows = folder.resolve("rows.csv");
    Path windows = folder.resolve("windows.csv");
    Shell heard =
        Shell.simbad("predict", out().toString(), LOG + "/readings.csv", "--out", rows.toString());
    assertEquals(0, heard.status(), heard.err());
    Shell moved =
        Shell.simbad("predict", out().toString(), LOG.toString(), "--out", windows.toString());
    assertEquals(0, moved.status(), moved.err());
    assertEquals(
        Files.readAllLines(LOG.resolve("readings.csv")).size(), Files.readAllLines(rows).size());
    assertTrue(Files.readAllLines(windows).get(0).startsWith("run,t_s,horizon_s,along_m_q05"));
  }

  /** The cause moves the robot, and is no part of what its sonar hears where it is. */
  @Test
  void theFolder_drivesWithBothHalves() {
    String model = "diagnosed:" + out();
    Shell driven =
        Shell.simbad(
            "run",
            "round",
            "--sensor",
            model,
            "--robot",
            model,
            "--out",
            folder.resolve("driven").toString());
    assertEquals(0, driven.status(), driven.err());
    assertTrue(
        driven.out().contains("diagnosed-wheels-too-large-on-wheels-too-large, round:"),
        driven.out());
  }

  @Test
  void brokenTrack_isSaidWithFileAndLine() throws IOException {
    Path broken = Files.createDirectory(folder.resolve("broken"));
    for (String file : List.of("scene.json", "readings.csv", "robot.json", "commands.csv")) {
      Files.copy(LOG.resolve(file), broken.resolve(file));
    }
    Files.writeString(broken.resolve("track.csv"), "run,t_s,x_m,z_m,heading_deg\nfirst,0,0,x,0\n");
    Shell shell =
        Shell.simbad("diagnose", broken.toString(), "--out", folder.resolve("no").toString());
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("track.csv:2: z_m"), shell.err());
  }

  /** The forecast that joint/make.py has in closed form, to a thousandth of what it says. */
  @Test
  void aGoldenDrive_isForecastAsInClosedForm() throws IOException {
    Path golden = LOGS.resolve("golden-drive");
    Path csv = folder.resolve("golden.csv");
    Shell shell =
        Shell.simbad("predict", golden.toString(), golden.toString(), "--out", csv.toString());
    assertEquals(0, shell.status(), shell.err());
    List<String> expected = Files.readAllLines(golden.resolve("windows.csv"));
    List<String> actual = Files.readAllLines(csv);
    assertEquals(expected.size(), actual.size());
    assertEquals(expected.get(0), actual.get(0));
    for (int i = 1; i < expected.size(); i++) {
      String[] wanted = expected.get(i).split(",", -1);
      String[] got = actual.get(i).split(",", -1);
      assertEquals(wanted.length, got.length);
      for (int k = 1; k < wanted.length; k++) {
        double tolerance = k < 3 + 2 * 19 ? 2e-5 : 2e-3;
        assertEquals(
            Double.parseDouble(wanted[k]), Double.parseDouble(got[k]), tolerance, "line " + i);
      }
    }
  }
}
