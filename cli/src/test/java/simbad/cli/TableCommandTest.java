package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TableCommandTest {
  private static final Path TABLES = Path.of("..", "data", "threshold-plots");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static String committed(String name) throws IOException {
    return Files.readString(TABLES.resolve(name + "-25mm.csv"));
  }

  private static void checkRefused(Shell shell, String names) {
    assertEquals(2, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(names), shell.err());
    assertEquals("", shell.out());
  }

  @ParameterizedTest
  @ValueSource(strings = {"square", "round"})
  void reconstruct_givesTheCommittedFile(String name) throws IOException {
    assertEquals(new Shell(0, committed(name), ""), Shell.simbad("table", "reconstruct", name));
    Path file = folder.resolve(name + ".csv");
    assertEquals(
        new Shell(0, "written to " + file + "\n", ""),
        Shell.simbad("table", "reconstruct", name, "--out", file.toString()));
    assertEquals(committed(name), Files.readString(file));
  }

  /** The angle was measured: there is nothing to reconstruct. */
  @Test
  void reconstruct_ofAnythingElse_isRefused() {
    checkRefused(
        Shell.simbad("table", "reconstruct", "angle"), "'angle' is neither square nor round");
    checkRefused(Shell.simbad("table", "reconstruct"), "square|round");
  }

  @Test
  void existingFiles_areKept() throws IOException {
    Path file = Files.writeString(folder.resolve("mine.svg"), "mine");
    checkRefused(
        Shell.simbad("table", "reconstruct", "round", "--out", file.toString()),
        file + ": exists already");
    checkRefused(
        Shell.simbad("table", "plot", "round", "--out", file.toString()),
        file + ": exists already");
    assertEquals("mine", Files.readString(file));
  }

  /** The least and the greatest value in the committed file are 0.06 and 3.16 m. */
  @Test
  void show_saysProvenanceSourceAndRange() {
    Shell shell = Shell.simbad("table", "show", "angle");
    assertEquals(0, shell.status());
    assertTrue(shell.out().startsWith("angle (measured)\n"), shell.out());
    assertTrue(shell.out().contains("  source: Kranz 2014"), shell.out());
    assertTrue(
        shell.out().contains("72 bearings, every 5.000 degrees; 0.06 to 3.16 m"), shell.out());
  }

  @Test
  void show_ofOwnTable_saysWhatItDoesNotSay() throws IOException {
    Path file = folder.resolve("mine.csv");
    Files.writeString(file, "bearing_deg,threshold_m\n0,1\n120,2.5\n240,0.5\n");
    Shell shell = Shell.simbad("table", "show", file.toString());
    assertEquals(0, shell.status());
    assertTrue(shell.out().startsWith("mine (provenance not stated)\n"), shell.out());
    assertTrue(
        shell.out().contains("3 bearings, every 120.0 degrees; 0.50 to 2.50 m"), shell.out());
  }

  /** A PNG begins with 137 and PNG, an SVG is a text that says so. */
  @ParameterizedTest
  @CsvSource({"square.png, PNG", "angle.PNG, PNG", "round.svg, <svg"})
  void plot_drawsByTheEnding(String name, String begin) throws IOException {
    Path file = folder.resolve(name);
    String obstacle = name.substring(0, name.indexOf('.'));
    assertEquals(
        new Shell(0, "", ""), Shell.simbad("table", "plot", obstacle, "--out", file.toString()));
    String head = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
    assertTrue(head.substring(0, 400).contains(begin), head.substring(0, 100));
  }

  /** What a predicted or captured table says of its uncertainty is drawn and named. */
  @Test
  void plot_drawsTheBandOfAPrediction() throws IOException {
    Path plate = folder.resolve("plate.svg");
    Path angle = folder.resolve("angle.svg");
    assertEquals(0, Shell.simbad("table", "plot", "plate", "--out", plate.toString()).status());
    assertEquals(0, Shell.simbad("table", "plot", "angle", "--out", angle.toString()).status());
    String filled = "rgb(210,220,228)";
    assertTrue(Files.readString(plate).contains(filled));
    assertFalse(Files.readString(angle).contains(filled));
  }

  /** The round table is a circle of 2 m; the log one of 2.1 m. */
  @Test
  void plot_withATrace_printsItsErrors() throws IOException {
    StringBuilder text = new StringBuilder("Jan 06, 2013 7:19:54 PM MyRobot performBehavior\n");
    for (int i = 0; i <= 3610; i++) {
      double angle = Math.toRadians(i / 10.0);
      text.append("INFO: " + 2.1 * Math.sin(angle) + "," + 2.1 * Math.cos(angle) + "\n");
    }
    Path log = Files.writeString(folder.resolve("robot.log"), text);
    Path file = folder.resolve("trace.svg");
    Shell shell =
        Shell.simbad("table", "plot", "round", "--log", log.toString(), "--out", file.toString());
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = shell.out().lines().toList();
    assertEquals(log + ": 3611 positions, 1 other lines", lines.get(0));
    assertTrue(
        lines.get(1).startsWith("radial error: mean 10.00, RMS 10.00, max 10.00 cm"), lines.get(1));
    assertTrue(lines.get(1).endsWith("0 of 72 bearings not crossed"), lines.get(1));
    assertTrue(Files.readString(file).contains("<svg"));
  }

  @Test
  void plot_withABrokenTrace_isRefused() throws IOException {
    Path log = Files.writeString(folder.resolve("robot.log"), "INFO: 0,1\nINFO: 0,NaN\n");
    Path file = folder.resolve("trace.svg");
    checkRefused(
        Shell.simbad("table", "plot", "round", "--log", log.toString(), "--out", file.toString()),
        log + ":2: z: found NaN");
    assertFalse(Files.exists(file));
  }

  @Test
  void plot_withoutAKnownEnding_isRefused() {
    Path file = folder.resolve("plot.pdf");
    checkRefused(
        Shell.simbad("table", "plot", "round", "--out", file.toString()),
        "ends neither in .png nor in .svg");
    checkRefused(Shell.simbad("table", "plot", "round"), "--out");
    assertFalse(Files.exists(file));
  }

  @Test
  void plot_intoAFolderThatIsNotThere_fails() {
    Path file = folder.resolve("nowhere/plot.svg");
    checkRefused(Shell.simbad("table", "plot", "round", "--out", file.toString()), "no such file");
    Path table = folder.resolve("nowhere/table.csv");
    checkRefused(
        Shell.simbad("table", "reconstruct", "round", "--out", table.toString()), "no such file");
  }

  /** A file that is called by its provenance would be "predicted (predicted)". */
  @Test
  void nameThatSaysItsProvenance_isNotFollowedByIt() throws IOException {
    Path hexagon = Path.of("..", "data", "obstacles", "hexagon", "table.csv");
    for (String name : List.of("predicted", "my-predicted", "Predicted", "unpredicted")) {
      Path file = Files.copy(hexagon, folder.resolve(name + ".csv"));
      boolean isSaid = !name.startsWith("un");
      String named = isSaid ? name : name + " (predicted)";
      Path picture = folder.resolve(name + ".svg");
      Shell shell =
          Shell.simbad("table", "compare", "angle", file.toString(), "--out", picture.toString());
      assertEquals(0, shell.status(), shell.err());
      assertTrue(shell.out().startsWith("angle (measured) and " + named + ", "), shell.out());
      Shell shown = Shell.simbad("table", "show", file.toString());
      assertTrue(shown.out().startsWith(named + "\n"), shown.out());
    }
  }
}
