package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TableImportCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Shell imported(String text, String... options) throws IOException {
    Path file = Files.writeString(folder.resolve("bench.csv"), text);
    String[] arguments = new String[options.length + 3];
    arguments[0] = "table";
    arguments[1] = "import";
    arguments[2] = file.toString();
    System.arraycopy(options, 0, arguments, 3, options.length);
    return Shell.simbad(arguments);
  }

  private static void checkTable(Shell shell, String rows) {
    assertEquals("", shell.err());
    assertEquals(0, shell.status());
    assertTrue(shell.out().endsWith("bearing_deg,threshold_m\n" + rows), shell.out());
  }

  @ParameterizedTest
  @CsvSource({
    "'Angle [deg],Distance (cm)'",
    "'angle,dist_cm'",
    "'deg,range_cm'",
    "'BEARING,Threshold_cm'"
  })
  void usualNames_andTheirUnit_areKnown(String names) throws IOException {
    checkTable(imported(names + "\n0,100\n120,250\n240,50\n"), "0,1.0\n120,2.5\n240,0.5\n");
  }

  @Test
  void rows_mayStandInAnyOrder_andEndWhereTheyBegan() throws IOException {
    checkTable(imported("angle,distance\n240,3\n0,1\n120,2\n360,1\n"), "0,1.0\n120,2.0\n240,3.0\n");
  }

  /** Clockwise 90 is counter-clockwise 270; the file's 0 stands at 90 here. */
  @Test
  void sense_andOffset_areTurned() throws IOException {
    String text = "phi,far\n0,1\n90,2\n180,3\n270,4\n";
    checkTable(
        imported(text, "--bearing", "phi", "--threshold", "far", "--clockwise"),
        "0,1.0\n90,4.0\n180,3.0\n270,2.0\n");
    checkTable(
        imported(text, "--bearing", "phi", "--threshold", "far", "--offset", "90"),
        "0,4.0\n90,1.0\n180,2.0\n270,3.0\n");
  }

  /** A file of the user's own cannot have two lines in one: that is said, not a fault. */
  @ParameterizedTest
  @ValueSource(strings = {"a\nb", "a\r\nb", "a\u0000b", "a\u2028b", "\u001b[2J"})
  void object_onTwoLines_isRefused(String object) throws IOException {
    Shell shell = imported("angle,distance\n0,1\n120,1\n240,1\n", "--object", object);
    assertEquals(2, shell.status());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().startsWith("simbad table import: --object: '"), shell.err());
    assertTrue(shell.err().contains("' is not a text of at most 10000 characters"), shell.err());
  }

  /** It could be written, but not read. */
  @Test
  void object_thatIsTooLong_isRefused() throws IOException {
    Shell shell = imported("angle,distance\n0,1\n120,1\n240,1\n", "--object", "x".repeat(10_001));
    assertEquals(2, shell.status());
    assertTrue(shell.err().length() < 500, shell.err());
  }

  @Test
  void fileNameOnTwoLines_isOneInTheHeader() throws IOException {
    Path file =
        Files.writeString(folder.resolve("a\nb.csv"), "angle,distance\n0,1\n120,1\n240,1\n");
    Shell shell = Shell.simbad("table", "import", file.toString());
    assertEquals("", shell.err());
    assertTrue(shell.out().startsWith("# source: imported from a b.csv\n"), shell.out());
  }

  @Test
  void header_keepsWhatTheFileSays_andWhatTheUserAdds() throws IOException {
    Shell shell =
        imported(
            "# date: 2031\nangle,distance\n0,100\n120,250\n240,50\n",
            "--unit",
            "cm",
            "--provenance",
            "measured",
            "--object",
            "a cup");
    checkTable(shell, "0,1.0\n120,2.5\n240,0.5\n");
    for (String line :
        new String[] {
          "date: 2031",
          "object: a cup",
          "provenance: measured",
          "unit: m",
          "source: imported from bench.csv"
        }) {
      assertTrue(shell.out().contains("# " + line + "\n"), shell.out());
    }
  }

  /** What is wrong is said in one line, and nothing is written. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "phi,distance/0,1/120,1/240,1 | no column has a known name for the bearing",
        "angle,far/0,1/120,1/240,1 | no column has a known name for the threshold",
        "angle,distance/0,1/120,1/250,1 | bench.csv:4: angle: found 250 where 3 even steps",
        "angle,distance/10,1/130,1/250,1 | where 3 even steps of a full turn from 0 have 0",
        "angle,distance/0,1/120,1/120,1 | appears twice",
        "angle,distance/0,1/180,1 | 2 bearings, expected at least 3",
        "angle,distance/0,1/120,x/240,1 | bench.csv:3: distance: 'x' is not a distance",
        "angle,distance/0,1/120,250/240,1 | '250' is not a distance in [0, 100.0] m",
      })
  void badFiles_areRefused(String text, String complaint) throws IOException {
    Path out = folder.resolve("out.csv");
    Shell shell = imported(text.strip().replace("/", "\n") + "\n", "--out", out.toString());
    assertEquals(2, shell.status());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertTrue(Files.notExists(out));
  }

  @Test
  void written_isReadBack() throws IOException {
    Path out = folder.resolve("mine.csv");
    Shell made = imported("angle,distance\n0,1\n120,2\n240,3\n", "--out", out.toString());
    assertEquals("written to " + out + "\n", made.out(), made.err());
    Shell shown = Shell.simbad("table", "show", out.toString());
    assertTrue(
        shown.out().contains("3 bearings, every 120.0 degrees; 1.00 to 3.00 m"), shown.out());
  }
}
