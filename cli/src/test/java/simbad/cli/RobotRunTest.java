package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A robot that does not do exactly what it is told goes round a circle of half a metre. */
class RobotRunTest {
  private static final String TABLE =
      "bearing_deg,threshold_m\n0,0.5\n45,0.5\n90,0.5\n135,0.5\n180,0.5\n225,0.5\n270,0.5\n315,0.5\n";
  private static final String UNICYCLE =
      "{\n\"format\": \"motion-gap/1\",\n\"kinematics\": \"unicycle\"%s\n}\n";
  private static final String MODEL =
      "{\n\"format\": \"motion-model/1\",\n\"forms\": [\n%s\n]\n}\n";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Shell run(String out, String... options) throws IOException {
    Path table = folder.resolve("circle.csv");
    Files.writeString(table, TABLE);
    List<String> words = new ArrayList<>(List.of("run", table.toString(), "--speed", "0.05"));
    words.addAll(List.of("--sensor", "shadow", "--out", folder.resolve(out).toString()));
    words.addAll(List.of(options));
    return Shell.simbad(words.toArray(String[]::new));
  }

  private String robot(String name, String more) throws IOException {
    Path file = folder.resolve(name + ".json");
    Files.writeString(file, UNICYCLE.formatted(more));
    return file.toString();
  }

  private String diagnosis(String name, String forms) throws IOException {
    Path diagnosis = Files.createDirectory(folder.resolve(name));
    Files.writeString(diagnosis.resolve("robot.json"), UNICYCLE.formatted(""));
    Files.writeString(diagnosis.resolve("motion.json"), MODEL.formatted(forms));
    return "diagnosed:" + diagnosis;
  }

  private List<String> trace(String out, String sensor) throws IOException {
    return Files.readAllLines(folder.resolve(out).resolve("circle/trace.csv")).stream()
        .filter(line -> line.startsWith(sensor + ","))
        .map(line -> line.substring(sensor.length()))
        .toList();
  }

  private JsonNode result(String out, int index) throws IOException {
    JsonNode errors =
        new ObjectMapper().readTree(folder.resolve(out).resolve("errors.json").toFile());
    return errors.get("results").get(index);
  }

  private static void checkDone(Shell shell) {
    assertEquals(0, shell.status(), shell.err());
  }

  /** The same bytes with a robot that does what it is told as with none. */
  @Test
  void exactRobot_goesTheSameWay() throws IOException {
    checkDone(run("none"));
    checkDone(run("exact", "--robot", robot("tin", "")));
    List<String> way = trace("none", "shadow");
    assertTrue(way.size() > 100);
    assertEquals(way, trace("exact", "shadow"));
    assertEquals(way, trace("exact", "shadow-on-tin"));
  }

  /** The experiment's own robot is written down as others are. */
  @Test
  void edgeFollower_isTheRobotOfTheExperiment() throws IOException {
    checkDone(run("none"));
    Path own = ProjectFolder.find().resolve("data/robots/edge-follower/robot.json");
    checkDone(run("own", "--robot", own.toString()));
    assertEquals(trace("none", "shadow"), trace("own", "shadow-on-robot"));
  }

  /** Half as fast, it takes twice the steps for the same circle; what scatters is left aside. */
  @Test
  void slowRobot_takesLonger_andTheReportSaysWhatMovingCosts() throws IOException {
    String half =
        "{\"form\": \"speed-scale\", \"parameters\": {\"speed_factor\": 0.5}},"
            + "{\"form\": \"slip\", \"parameters\": {\"share_of_windows\": 0.1}}";
    Shell shell = run("slow", "--robot", diagnosis("half", half));
    checkDone(shell);
    assertEquals("shadow-on-half", result("slow", 1).get("sensor").asText());
    double steps = result("slow", 1).get("steps").asDouble();
    assertEquals(2, steps / result("slow", 0).get("steps").asDouble(), 0.35);
    Matcher said =
        Pattern.compile(
                "circle, shadow sensor on half: mean error against the table (\\S+) cm as"
                    + " believed, (\\S+) cm from moving alone")
            .matcher(shell.out());
    assertTrue(said.find(), shell.out());
    assertEquals(
        result("slow", 1).get("mean_abs_cm").asDouble(), Double.parseDouble(said.group(2)), 0.006);
    String page = Files.readString(folder.resolve("slow/report.html"));
    assertTrue(page.contains(said.group()), "the page says it too");
    assertTrue(page.contains("on a robot that moves as half"), "and what the word means");
  }

  /** A robot that is late goes round once it is given time to do what it is told. */
  @Test
  void lateRobot_isWaitedFor() throws IOException {
    String late = robot("late", ",\n\"latency_s\": 0.25");
    Shell shell = run("waited", "--robot", late, "--wait", "0.3");
    checkDone(shell);
    assertEquals(0, result("waited", 1).get("unreached_bearings").asInt(), shell.out());
    assertEquals(
        result("waited", 0).get("mean_abs_cm").asDouble(),
        result("waited", 1).get("mean_abs_cm").asDouble(),
        0.5);
    assertTrue(Files.readString(folder.resolve("waited/errors.json")).contains("\"wait_s\""));
  }

  /** Of a log of slow bends nothing follows for turns on the spot; one line says so. */
  @Test
  void beyondTheLog_isSaid() throws IOException {
    String robot =
        diagnosis("slow", "{\"form\": \"speed-scale\", \"parameters\": {\"speed_factor\": 0.99}}");
    Path model = folder.resolve("slow/motion.json");
    String within = "\"commanded\": {\"max_speed_m_s\": 0.05, \"max_turn_rad_s\": 0.4}";
    Files.writeString(model, Files.readString(model).replace("\"forms\"", within + ",\n\"forms\""));
    Shell shell = run("beyond", "--robot", robot);
    checkDone(shell);
    assertEquals(
        "note: --robot: the log of slow has commands of up to 0.0500 m/s and 0.400 rad/s, this run"
            + " asks for up to 0.0500 m/s and 6.28 rad/s: how the robot moves there is not known",
        shell.err().strip());
    assertEquals("", run("within", "--robot", robot, "--turn-rate", "0.4").err());
  }

  @Test
  void diagnosisThatFoundNothing_isSaidToChangeNothing() throws IOException {
    Shell shell = run("unchanged", "--robot", diagnosis("sound", ""));
    checkDone(shell);
    assertEquals(1, shell.err().lines().count(), shell.err());
    assertTrue(
        shell.err().startsWith("note: --robot: the diagnosis in ")
            && shell.err().contains("nothing is applied"),
        shell.err());
  }

  /** A robot that hardly turns drives away; the last line says what may help. */
  @Test
  void lostRobot_isAdvised() throws IOException {
    String stiff =
        "{\"form\": \"saturation: turning\", \"parameters\": {\"max_turn_rad_s\": 0.02}}";
    Shell shell = run("lost", "--robot", diagnosis("stiff", stiff));
    checkDone(shell);
    assertEquals(
        "note: shadow-on-stiff never found the edge of circle: tell it to turn more slowly than 6.28"
            + " rad/s (--turn-rate), or give it time after each step (--wait, now 0.0 s)",
        shell.err().strip());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"form\": \"warp\", \"parameters\": {}} | the name of a form",
        "{\"form\": \"speed-scale\", \"parameters\": {}} | speed_factor",
        "{\"form\": \"speed-scale\", \"parameters\": {\"speed_factor\": 900}} | in [0.2, 5",
      })
  void wrongModel_isNamed(String forms, String said) throws IOException {
    Shell shell = run("wrong", "--robot", diagnosis("broken", forms));
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("motion.json:"), shell.err());
    assertTrue(shell.err().contains(said), shell.err());
    assertEquals(1, shell.err().lines().count(), shell.err());
  }

  @Test
  void missingFiles_andBadWaits_areSaid() throws IOException {
    Shell none = run("none", "--robot", "diagnosed:" + folder.resolve("nowhere"));
    assertEquals(2, none.status());
    assertTrue(none.err().contains("motion.json"), none.err());
    assertEquals(2, run("none", "--robot", folder.resolve("no.json").toString()).status());
    for (String wait : List.of("-1", "NaN", "6")) {
      Shell shell = run("none", "--wait", wait);
      assertEquals(2, shell.status());
      assertTrue(shell.err().contains("--wait"), shell.err());
    }
  }
}
