package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BatchPlotCommandTest {
  private static final String HEADER =
      "sensor,status,controller.angle,controller.curl,mean_abs_cm,simulated_s\n";

  /** Two sensors whose error is the same everywhere, and one that has a best angle. */
  private static final String ROWS =
      """
      original,done,20,0.1,100,60
      original,done,40,0.1,100,50
      overlap,done,20,0.1,300,90
      overlap,done,40,0.1,300,80
      shadow,done,20,0.1,1,60
      shadow,done,40,0.1,2,70
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void writeRows() throws IOException {
    Files.writeString(folder.resolve("results.csv"), HEADER + ROWS);
  }

  private Shell plot(String... more) {
    List<String> words =
        new ArrayList<>(List.of("batch-plot", folder.toString(), "--along", "angle"));
    words.addAll(List.of("--out", folder.resolve("plot.svg").toString()));
    words.addAll(List.of(more));
    return Shell.simbad(words.toArray(String[]::new));
  }

  @Test
  void oneParameter_needsNoCurves_andEachSensorHasItsColour() throws IOException {
    assertEquals(
        new Shell(
            0,
            """
            original: angle 40 (the same error everywhere, the least time: 100.00 cm, 50 s)
            overlap: angle 40 (the same error everywhere, the least time: 300.00 cm, 80 s)
            shadow: angle 20 (the least error: 1.00 cm, 60 s)
            """,
            ""),
        plot());
    String svg = Files.readString(folder.resolve("plot.svg"));
    for (String colour : List.of("213,94,0", "0,158,115", "86,180,233")) {
      assertTrue(svg.contains("stroke:rgb(" + colour + ")"), colour);
    }
  }

  @Test
  void parameterThatIsNotDrawn_isNamed() throws IOException {
    Files.writeString(folder.resolve("results.csv"), HEADER + ROWS + "shadow,done,20,0.3,3,60\n");
    assertTrue(plot().out().endsWith("means over curl too\n"));
  }

  @Test
  void curves_areStillDrawn() {
    Shell shell = plot("--curves", "curl", "--sensor", "shadow,original");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("shadow: angle 20, curl 0.1 ("), shell.out());
    assertFalse(shell.out().contains("overlap"), shell.out());
  }

  @Test
  void whatCannotBeDrawn_isRefused() throws IOException {
    checkRefused(plot("--curves", "angle"), "--curves: angle is on the axis already");
    checkRefused(
        plot("--sensor", "shado"), "--sensor: 'shado' is not one of original, overlap, shadow");
    StringBuilder rows = new StringBuilder(HEADER);
    for (int i = 0; i < 7; i++) {
      rows.append("diagnosed-" + i + ",done,20,0.1," + i + ",60\n");
    }
    Files.writeString(folder.resolve("results.csv"), rows);
    checkRefused(plot(), "7 sensors, but only 6 have colours of their own");
    rows.setLength(HEADER.length());
    for (int i = 0; i < 19; i++) {
      rows.append("shadow,done,20," + i + "," + i + ",60\n");
    }
    Files.writeString(folder.resolve("results.csv"), rows);
    checkRefused(plot("--curves", "curl"), "19 values of curl, but only 18 curves");
  }

  private void checkRefused(Shell shell, String complaint) {
    assertEquals(2, shell.status(), shell.err());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertTrue(Files.notExists(folder.resolve("plot.svg")));
  }
}
