package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;

/** The log of a robot whose ways are all 10 % shorter than it was told. */
class DiagnoseMotionTest {
  private static final double SHARE = 0.9;
  private static final double SIGMA_M = 0.001;
  private static final int STEPS = 1200;
  private static final double STEP_S = 0.1;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void write() throws IOException {
    SplittableRandom random = new SplittableRandom(1);
    List<Command> commands = new ArrayList<>();
    List<TrackPose> track = new ArrayList<>();
    Command command = new Command(0, 0, 0);
    double x = 0;
    double y = 0;
    double heading = 0;
    for (int i = 0; i < STEPS; i++) {
      track.add(
          new TrackPose(
              i * STEP_S,
              x + SIGMA_M * random.nextGaussian(),
              y + SIGMA_M * random.nextGaussian(),
              Math.IEEEremainder(heading + SIGMA_M * random.nextGaussian(), 2 * Math.PI)));
      if (i % 20 == 0) {
        command =
            new Command(
                i * STEP_S, 0.1 + 0.2 * random.nextDouble(), 1.5 * random.nextDouble() - 0.75);
        commands.add(command);
      }
      // A step is a part of a circle; its chord has the direction of its middle.
      double turn = command.turnRadPerS() * STEP_S;
      double chord =
          SHARE * command.speedMPerS() * STEP_S * (turn == 0 ? 1 : Math.sin(turn / 2) / (turn / 2));
      x += chord * Math.cos(heading + turn / 2);
      y += chord * Math.sin(heading + turn / 2);
      heading += turn;
    }
    Robot robot = new Robot(false, 0, false, SIGMA_M, SIGMA_M, MotionChain.EXACT);
    MotionRun run = new MotionRun("a", commands, track);
    new MotionFolder(folder.resolve("short-ways"))
        .write(new MotionData("short-ways", robot, List.of(run), List.of()));
  }

  private Shell diagnose(String... options) {
    List<String> words =
        new ArrayList<>(
            List.of(
                "diagnose",
                folder.resolve("short-ways").toString(),
                "--out",
                folder.resolve("out").toString()));
    words.addAll(List.of(options));
    return Shell.simbad(words.toArray(String[]::new));
  }

  @Test
  void shortWays_areNamed_andTheirModelDrivesARobot() throws IOException {
    Shell shell = diagnose("--json");
    assertEquals(0, shell.status(), shell.err());
    JsonNode line = new ObjectMapper().readTree(shell.out());
    assertEquals("explained", line.get("verdict").asText(), shell.out());
    assertEquals("speed-scale", line.get("explanation").get(0).asText());
    assertEquals(1, line.get("explanation").size());
    assertTrue(line.get("shrink").asDouble() > 0.5, shell.out());
    Path out = Path.of(line.get("folder").asText());
    JsonNode form =
        new ObjectMapper().readTree(out.resolve("motion.json").toFile()).get("forms").get(0);
    assertEquals(SHARE, form.get("parameters").get("speed_factor").asDouble(), 0.005);
    Shell driven =
        Shell.simbad(
            "run",
            "round",
            "--sensor",
            "shadow",
            "--robot",
            "diagnosed:" + out,
            "--out",
            folder.resolve("driven").toString());
    assertEquals(0, driven.status(), driven.err());
    assertTrue(driven.out().contains("from moving alone"), driven.out());
  }

  @Test
  void theLine_saysVerdictAndEffect() {
    Shell shell = diagnose();
    assertEquals(0, shell.status(), shell.err());
    String line = shell.out().lines().findFirst().orElseThrow();
    assertTrue(line.startsWith("short-ways: explained; "), shell.out());
    assertTrue(line.contains("speed-scale"), shell.out());
  }

  private Shell predict(String model, Path out) {
    return Shell.simbad(
        "predict",
        folder.resolve("out/short-ways").toString(),
        folder.resolve("short-ways").toString(),
        "--out",
        out.toString(),
        "--model",
        model);
  }

  /** 239 windows of half a second and more: the tracker sees the robot from 0 to 119.9 s. */
  @Test
  void windows_areForecast_inTheColumnsOfTheFormat() throws IOException {
    assertEquals(0, diagnose().status());
    Path csv = folder.resolve("windows.csv");
    Shell shell = predict("diagnosed", csv);
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = Files.readAllLines(csv);
    List<String> columns = List.of(lines.get(0).split(",", -1));
    assertEquals(3 + 3 * 19, columns.size());
    assertEquals("run,t_s,horizon_s,along_m_q05", String.join(",", columns.subList(0, 4)));
    assertEquals("turn_deg_q95", columns.get(columns.size() - 1));
    assertTrue(lines.get(1).startsWith("a,0,0.5,"), lines.get(1));
    assertTrue(lines.get(2).startsWith("a,0,2,"), lines.get(2));
    Path nominal = folder.resolve("nominal.csv");
    assertEquals(0, predict("nominal", nominal).status());
    double told = median(Files.readAllLines(nominal).get(1));
    assertEquals(SHARE, median(lines.get(1)) / told, 0.03);
  }

  @Test
  void aTableInThePlaceOfAMotionFolder_isNamed() throws IOException {
    assertEquals(0, diagnose().status());
    String table = folder.resolve("short-ways/commands.csv").toString();
    Shell shell =
        Shell.simbad(
            "predict",
            folder.resolve("out/short-ways").toString(),
            table,
            "--out",
            folder.resolve("none.csv").toString());
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains(table + ": is no folder, expected a motion"), shell.err());
  }

  private static double median(String line) {
    return Double.parseDouble(line.split(",", -1)[3 + 9]);
  }

  /** What comes after a window's end changes no digit of its forecast. */
  @Test
  void forecasts_neverSeeTheTrackThatFollows() throws IOException {
    assertEquals(0, diagnose().status());
    Path before = folder.resolve("before.csv");
    assertEquals(0, predict("diagnosed", before).status());
    Path track = folder.resolve("short-ways/track.csv");
    List<String> rows = new ArrayList<>(Files.readAllLines(track));
    rows.subList(rows.size() / 2, rows.size())
        .replaceAll(row -> row.replaceFirst(",[^,]*,[^,]*,[^,]*$", ",5,5,77"));
    Files.write(track, rows);
    Path after = folder.resolve("after.csv");
    assertEquals(0, predict("diagnosed", after).status());
    assertEquals(Files.readString(before), Files.readString(after));
  }

  /** A track of the day's clock is no drive of 50 years. */
  @Test
  void trackOfAnotherClock_isNotForecast() throws IOException {
    assertEquals(0, diagnose().status());
    Path track = folder.resolve("short-ways/track.csv");
    List<String> rows = new ArrayList<>(Files.readAllLines(track));
    String[] last = rows.get(rows.size() - 1).split(",", -1);
    last[1] = "1700000000";
    rows.add(String.join(",", last));
    Files.write(track, rows);
    Shell shell = predict("diagnosed", folder.resolve("never.csv"));
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("track.csv:2: t_s: the track of run"), shell.err());
  }

  /** For programs too: what the audit found is told though it does not stop the fit. */
  @Test
  void audit_isInTheJsonLine() throws IOException {
    Path track = folder.resolve("short-ways/track.csv");
    List<String> rows = new ArrayList<>(Files.readAllLines(track));
    String[] cells = rows.get(500).split(",", -1);
    cells[2] = Double.toString(5 + Double.parseDouble(cells[2]));
    rows.set(500, String.join(",", cells));
    Files.write(track, rows);
    JsonNode line = new ObjectMapper().readTree(diagnose("--json").out());
    assertEquals("track-jump", line.at("/audit/0/check").asText(), line.toString());
  }

  @Test
  void millimetres_areRefused_withTheLineAndWhatToDo() throws IOException {
    Path track = folder.resolve("short-ways/track.csv");
    List<String> rows = new ArrayList<>(Files.readAllLines(track));
    for (int i = 1; i < rows.size(); i++) {
      String[] cells = rows.get(i).split(",", -1);
      cells[2] = Double.toString(1000 * Double.parseDouble(cells[2]));
      cells[3] = Double.toString(1000 * Double.parseDouble(cells[3]));
      rows.set(i, String.join(",", cells));
    }
    Files.write(track, rows);
    Shell shell = diagnose();
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("track.csv:"), shell.err());
    assertTrue(shell.err().contains("divide x_m and z_m by 1000"), shell.err());
    JsonNode json =
        new ObjectMapper().readTree(folder.resolve("out/short-ways/diagnosis.json").toFile());
    assertEquals("refuse", json.at("/audit/0/severity").asText());
    assertFalse(json.has("verdict"));
  }

  private Set<ValidationMessage> faults() throws IOException {
    String schema = Files.readString(Path.of("..", "docs", "schema", "diagnosis.schema.json"));
    return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
        .getSchema(schema)
        .validate(json());
  }

  private JsonNode json() throws IOException {
    return new ObjectMapper().readTree(folder.resolve("out/short-ways/diagnosis.json").toFile());
  }

  @Test
  void diagnosis_fitsTheSchema_andThePageSaysTheSame() throws IOException {
    assertEquals(0, diagnose().status());
    assertEquals(Set.of(), faults());
    JsonNode json = json();
    assertEquals(14, json.get("effects").size());
    assertTrue(json.at("/effects/0/remedy").asText().startsWith("multiply"), json.toString());
    double parts = 0;
    for (JsonNode part : json.get("budget")) {
      parts += part.get("share").asDouble();
    }
    assertEquals(1, parts, 1e-4);
    String page = Files.readString(folder.resolve("out/short-ways/report.html"));
    assertTrue(page.contains(json.get("reason").asText()), json.get("reason").asText());
    assertTrue(page.contains("speed-scale"), "the name");
  }

  @Test
  void audit_fitsTheSchema() throws IOException {
    assertEquals(0, diagnose("--audit-only").status());
    assertEquals(Set.of(), faults());
  }

  @Test
  void auditOnly_fitsNothing() {
    Shell shell = diagnose("--audit-only");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("short-ways: the audit found nothing"), shell.out());
    assertFalse(Files.exists(folder.resolve("out/short-ways/motion.json")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--corrected=scene.json"})
  void whatAMotionFolderHasNot_isSaid(String option) {
    Shell shell = diagnose(option);
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("short-ways is a motion folder, which has no"), shell.err());
    assertFalse(Files.exists(folder.resolve("out/short-ways")));
  }
}
