package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FidelityCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @Test
  void shadowSensor_isFaithful_andLeavesItsTraces() throws IOException {
    Path out = folder.resolve("out");
    Shell shell = Shell.simbad("fidelity", "round", "--speed", "0.1", "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    assertTrue(
        shell
            .out()
            .matches(
                "round, shadow: faithful\n  agrees at (100|99\\.\\d+).* of 39,366 poses; mean "
                    + "radial error \\d\\.\\d\\d cm; mean distance from the edge 0\\.\\d\\d cm; 0 "
                    + "bearings not reached\nwritten to .*out \\(open .*report.html\\)\n"),
        shell.out());
    assertTrue(Files.exists(out.resolve("round/map.csv")));
    assertTrue(Files.exists(out.resolve("round/trace.csv")));
    assertTrue(Files.exists(out.resolve("errors.json")));
    String page = Files.readString(out.resolve("report.html"));
    assertFirst(page, "Is the shadow sensor faithful?", "<strong>round, shadow</strong>: faithful");
    assertTrue(page.contains("<td>at most 3 cm</td>"), page);
    assertFalse(page.contains("<strong>missed"), page);
    assertFalse(page.contains("reduction"), page);
    assertTrue(page.contains("radial error by bearing, logarithmic."), page);
  }

  /** Title and verdict stand before the first picture, the first note and the table of errors. */
  private static void assertFirst(String page, String title, String verdict) {
    String top = page.substring(page.indexOf("<main>"), page.indexOf("class=\"note\""));
    assertTrue(top.contains("<h1>" + title + "</h1>"), top);
    assertTrue(top.contains(verdict), top);
    assertFalse(top.contains("<svg"), top);
  }

  /** Nothing on the page is of a logarithmic plot or of a shadow sensor: there is neither. */
  @Test
  void originalSensorsPage_saysWhatItMissed_andOnlyWhatIsThere() throws IOException {
    Path out = folder.resolve("out");
    Shell shell =
        Shell.simbad(
            "fidelity", "round", "--sensor", "original", "--speed", "0.1", "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    String page = Files.readString(out.resolve("report.html"));
    String sentence =
        shell.out().lines().findFirst().orElseThrow().replaceFirst("^round, original: ", "");
    assertFirst(
        page, "Is the original sensor faithful?", "<strong>round, original</strong>: " + sentence);
    assertEquals(4, page.split("<strong>missed</strong>", -1).length - 1, page);
    assertEquals(2, page.split("<td>held</td>", -1).length - 1, page);
    assertFalse(page.contains("logarithmic"), page);
    assertFalse(page.contains("shadow sensor"), page);
    assertFalse(page.contains("reduction"), page);
  }

  @Test
  void originalSensor_isNot() {
    Shell shell = Shell.simbad("fidelity", "round", "--sensor", "original", "--speed", "0.1");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("round, original: not faithful: agrees at "), shell.out());
  }

  /** A per cent sign in a help text is a format to picocli, which warns of it on stderr. */
  @Test
  void help_isPrintedWithoutAWarning() {
    PrintStream before = System.err;
    ByteArrayOutputStream warnings = new ByteArrayOutputStream();
    System.setErr(new PrintStream(warnings, true, StandardCharsets.UTF_8));
    try {
      assertTrue(Shell.simbad("fidelity", "--help").out().contains("at 98 % of the poses"));
    } finally {
      System.setErr(before);
    }
    assertEquals("", warnings.toString(StandardCharsets.UTF_8));
  }

  @Test
  void wrongFigures_areRefused() {
    assertEquals(2, Shell.simbad("fidelity", "round", "--speed", "0").status());
    assertEquals(2, Shell.simbad("fidelity", "round", "--sensor", "ear").status());
    assertEquals(2, Shell.simbad("fidelity", "nothing").status());
    Shell twice = Shell.simbad("fidelity", "round", "round");
    assertEquals(2, twice.status());
    assertTrue(twice.err().contains("OBSTACLE: two are called round"), twice.err());
  }
}
