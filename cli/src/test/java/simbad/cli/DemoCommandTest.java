package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.demo.DemoManager;

class DemoCommandTest {
  private static void checkRefused(String names, String... arguments) {
    Shell shell = Shell.simbad(arguments);
    assertEquals(2, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(names), shell.err());
    assertEquals("", shell.out());
  }

  /** Those of the world and those of this module, which come as a service. */
  /** The window and the headless run take an obstacle by name. */
  @Test
  void obstacle_byName_isADemo() {
    Shell shell = Shell.simbad("demo", "plate", "--headless", "--steps", "20");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("ObstacleDemo: 20 steps"), shell.out());
  }

  @Test
  void list_namesAllDemos() {
    Shell shell = Shell.simbad("demo", "--list");
    assertEquals(0, shell.status());
    assertEquals(DemoManager.names(), shell.out().lines().toList());
    assertTrue(shell.out().contains("SimplestDemo") && shell.out().contains("AngleDemo"));
  }

  @Test
  void headless_saysWhereEverybodyIs() {
    Shell shell = Shell.simbad("demo", "SimplestDemo", "--headless", "--steps", "40");
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = shell.out().lines().toList();
    assertEquals(2, lines.size(), shell.out());
    assertTrue(
        lines.get(0).matches("SimplestDemo: 40 steps \\(2\\.0 s simulated\\), \\d+ steps/s"),
        shell.out());
    // 40 steps of 0.05 s at 0.5 m/s along x.
    assertEquals("  robot: at x 1.00, z 0.00 m, heading 0 degrees, drove 1.00 m", lines.get(1));
  }

  @Test
  void headless_saysWhatHappened() {
    String cherries = Shell.simbad("demo", "PickCherriesDemo", "--headless").out();
    assertTrue(cherries.startsWith("PickCherriesDemo: 2000 steps"), cherries);
    assertEquals(
        12, cherries.lines().filter(line -> line.endsWith("taken out of the world")).count());
    String balls = Shell.simbad("demo", "pushballs", "--headless").out();
    assertTrue(balls.contains("bumped in"), balls);
    String simplest = Shell.simbad("demo", "SIMPLEST", "--headless").out();
    assertTrue(simplest.contains("blocked in"), simplest);
  }

  @ParameterizedTest
  @CsvSource({
    "Avoider, AvoidersDemo",
    "LineDemon, LineDemo",
    "khepra, KheperaDemo",
    "square_demo, SquareDemo"
  })
  void unknownName_isToldWhatIsNear(String name, String near) {
    checkRefused("NAME: '" + name + "' is not a demo, did you mean", "demo", name, "--headless");
    assertTrue(Shell.simbad("view", name).err().contains(near));
    assertEquals(2, Shell.simbad("view", name).status());
  }

  @ParameterizedTest
  @ValueSource(strings = {"view", "demo LineDemo"})
  void window_withoutADisplay_fails(String command) {
    Shell shell = Shell.simbad(command.split(" ", -1));
    assertEquals(1, shell.status());
    assertTrue(shell.err().contains("there is no display; simbad demo NAME --headless"));
  }

  /** It takes its time: in 40 steps it has hardly begun, and a robot as told is on its way. */
  @Test
  void robot_movesAsAnother(@TempDir Path folder) throws IOException {
    Path late = folder.resolve("late.json");
    Files.writeString(
        late, "{\"format\": \"motion-gap/1\", \"kinematics\": \"unicycle\", \"latency_s\": 0.2}");
    String told = Shell.simbad("demo", "angle", "--headless", "--steps", "400").out();
    String moved =
        Shell.simbad("demo", "angle", "--headless", "--steps", "400", "--robot", "" + late).out();
    assertTrue(moved.startsWith("ObstacleDemo: 400 steps"), moved);
    assertTrue(drove(moved) < drove(told) / 2, moved + told);
    assertTrue(drove(moved) > 0, moved);
    checkRefused(
        "--robot needs the demo of an obstacle",
        "demo",
        "LineDemo",
        "--headless",
        "--robot",
        "" + late);
    checkRefused("nowhere.json", "demo", "angle", "--headless", "--robot", "nowhere.json");
  }

  private static double drove(String said) {
    return Double.parseDouble(said.replaceAll("(?s).*drove ([0-9.]+) m.*", "$1"));
  }

  @Test
  void wrongUsage_isRefused() {
    checkRefused("expected the NAME of a demo: one of BaseDemo, ", "demo", "--headless");
    checkRefused("--steps: 0 is not in", "demo", "LineDemo", "--headless", "--steps", "0");
    checkRefused("--steps needs --headless", "demo", "LineDemo", "--steps", "10");
    checkRefused("--steps", "demo", "LineDemo", "--headless", "--steps", "many");
  }
}
