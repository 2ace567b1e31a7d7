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
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;

class TablePredictCommandTest {
  private static final String POST = "# object: a small post\nx_mm,z_mm\n5,5\n5,-5\n-5,-5\n-5,5\n";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private String post() throws IOException {
    return Files.writeString(folder.resolve("post.csv"), POST).toString();
  }

  @Test
  void predict_writesATableWithItsBandAndOrigin() throws IOException, DataFormatException {
    Path out = folder.resolve("table.csv");
    Shell shell =
        Shell.simbad(
            "table",
            "predict",
            post(),
            "--bearings",
            "24",
            "--temperature",
            "5",
            "--humidity",
            "80",
            "--out",
            out.toString());
    assertEquals(new Shell(0, "written to " + out + "\n", ""), shell);
    String text = Files.readString(out);
    for (String line :
        new String[] {
          "object: a small post",
          "sensor: SRF04",
          "provenance: predicted",
          "temperature_c: 5",
          "humidity_percent: 80",
          "unit: m"
        }) {
      assertTrue(text.contains("# " + line + "\n"), text);
    }
    assertTrue(text.contains("\nbearing_deg,threshold_m,threshold_low_m,threshold_high_m\n"), text);
    TableDocument document = TableFile.read(out);
    assertEquals(24, document.table().size());
    assertEquals("predicted", document.provenanceWord());
    // A quarter of the turn is a quarter of the section.
    assertEquals(document.table().valueM(3), document.table().valueM(9), 0.002);
  }

  @Test
  void sameInput_givesTheSameBytes() throws IOException {
    Shell once = Shell.simbad("table", "predict", post(), "--bearings", "12");
    assertEquals(once, Shell.simbad("table", "predict", post(), "--bearings", "12"));
    assertEquals(0, once.status());
  }

  /**
   * A sensor that gives up at half a metre hears no further; one that is blind below is 0 there.
   */
  @Test
  void sensorFile_boundsTheTable() throws IOException, DataFormatException {
    String srf04 = Files.readString(Path.of("..", "data", "sensors", "srf04.json"));
    Path sensor =
        Files.writeString(
            folder.resolve("short.json"),
            srf04.replace("\"max_range_m\": 6.0", "\"max_range_m\": 0.5"));
    Path out = folder.resolve("table.csv");
    Shell.simbad(
        "table",
        "predict",
        post(),
        "--bearings",
        "8",
        "--sensor-file",
        sensor.toString(),
        "--out",
        out.toString());
    assertEquals(0.5, TableFile.read(out).table().greatestM(), 1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--temperature 100 | --temperature: 100.0 is not in [-40.0, 60.0]",
        "--humidity -1 | --humidity: -1.0 is not in [0.0, 100.0]",
        "--bearings 2 | --bearings: 2 is not in [3, 3600]",
      })
  void badFigures_areRefused(String option, String complaint) throws IOException {
    String[] words = option.strip().split(" ", 2);
    checkRefused(Shell.simbad("table", "predict", post(), words[0], words[1]), complaint);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "x_m,z_m/0,0/0.01,0 | 2 different corners, expected at least 3",
        "x_m,z_m/0,0/0.01,0.01/0.01,0/0,0.01 | crosses or touches itself",
        "x_m,z_m/0,0/25,0/25,25 | '25' is not a length within 1.0 m of the axis",
        "x_m,y_m/0,0/1,0/1,1 | z_m: column is missing",
        "x_m,z_m/0,0/0.9,0/0.9,0.9 | reaches 1.273 m from the axis, expected a post of 0.001 to 0.25 m",
        "x_m,z_m/0,0/1e-6,0/0,1e-6 | reaches 1.000e-06 m from the axis, expected a post of 0.001 to",
      })
  void badOutlines_areRefused(String text, String complaint) throws IOException {
    Path file =
        Files.writeString(folder.resolve("bad.csv"), text.strip().replace("/", "\n") + "\n");
    checkRefused(Shell.simbad("table", "predict", file.toString()), complaint);
  }

  /** A scanned post: a valid outline, but a system of equations of gigabytes. */
  @Test
  void scannedOutlines_areRefused() throws IOException {
    StringBuilder text = new StringBuilder("x_m,z_m\n");
    for (int i = 0; i < 1001; i++) {
      double angle = 2 * Math.PI * i / 1001;
      text.append(0.01 * Math.cos(angle)).append(',').append(0.01 * Math.sin(angle)).append('\n');
    }
    Path file = Files.writeString(folder.resolve("scan.csv"), text);
    checkRefused(
        Shell.simbad("table", "predict", file.toString()),
        "has 1001 corners, expected at most 1000");
  }

  /** The committed tables are what the command prints. */
  @ParameterizedTest
  @ValueSource(strings = {"half-round", "hexagon", "plate", "tee", "channel", "leg-pair"})
  void shippedTables_areThePredictions(String name) throws IOException {
    Path type = Path.of("..", "data", "obstacles", name);
    Shell shell = Shell.simbad("table", "predict", type.resolve("outline.csv").toString());
    assertEquals(Files.readString(type.resolve("table.csv")), shell.out(), shell.err());
  }

  /** The committed constants are what the command fits. */
  @Test
  void calibrate_findsTheFiguresInUse() {
    Shell words = Shell.simbad("table", "calibrate", "--without-angle");
    assertEquals(0, words.status(), words.err());
    assertTrue(words.out().contains("  level L 34.75 dB\n  K 27.5\n  tau 1.75 ms\n"), words.out());
    Shell all = Shell.simbad("table", "calibrate");
    assertEquals(
        """
        fitted to: round, square (words), angle (72 measured)
          level L 33.75 dB
          K 24.0
          tau 1.75 ms
          band 4.25 dB either way
        the figures in use are those of the fit
        """,
        all.out());
    assertEquals(0, all.status(), all.err());
  }

  private static void checkRefused(Shell shell, String complaint) {
    assertEquals(2, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertEquals("", shell.out());
  }

  @Test
  void compare_saysHowAlikeTwoTablesAre() throws IOException {
    Path picture = folder.resolve("both.svg");
    Shell shell =
        Shell.simbad(
            "table", "compare", "square", "round", "--out", picture.toString(), "--bearings");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(
        shell.out().startsWith("square (reconstructed) and round (reconstructed), 72 bearings"));
    assertTrue(
        shell
            .out()
            .contains("\nbearing_deg,first_m,second_m,difference_m\n0,2.500,2.000,-0.500\n"));
    assertTrue(Files.readString(picture).contains("<svg"));
  }

  @Test
  void compare_asJson_hasEveryBearing() {
    Shell shell = Shell.simbad("table", "compare", "angle", "angle", "--json");
    assertTrue(shell.out().contains("\"log_correlation\":1.0") || shell.out().contains("0.99999"));
    assertTrue(shell.out().contains("{\"bearing_deg\":355.0,\"first_m\":3.09,\"second_m\":3.09}"));
  }

  @Test
  void compare_withoutAKnownEnding_isRefused() {
    Path picture = folder.resolve("both.pdf");
    checkRefused(
        Shell.simbad("table", "compare", "angle", "round", "--out", picture.toString()),
        "ends neither in .png nor in .svg");
  }
}
