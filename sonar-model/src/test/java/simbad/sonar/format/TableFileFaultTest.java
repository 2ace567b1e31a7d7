package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every way we know to spoil a table: the message names file, line and field. */
class TableFileFaultTest {
  private static final String HEADER = "bearing_deg,threshold_m\n";

  @TempDir private Path directory = Path.of("target");

  private void check(String text, String where, String... parts) throws Exception {
    Faults.check(TableFile::read, Faults.file(directory, text), where, parts);
  }

  /** One bad field in the third line of a table. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "NaN", "nan", "-1", "-0.001", "1e9", "100.1", "1e999", "Infinity", "", "abc", "1 m", "0.5m",
        "1.2.3", "0x1p0", "1d", "1f", "--1", "1e", "e1", ".", "+", "1_000", "\u0661", "\uFF11",
        "1 2", "null", "'1'"
      })
  void threshold_thatIsNone_isRefused(String bad) throws Exception {
    check(
        HEADER + "0,1\n90," + bad + "\n180,3\n270,4\n",
        ":3: threshold_m: ",
        "'" + bad + "' is not a distance in [0, 100.0] m");
  }

  @Test
  void headerLine_thatIsTooLong_isRefused() throws Exception {
    String rows = HEADER + "0,1\n90,1\n180,3\n270,4\n";
    check("# object: " + "n".repeat(5_000_000) + "\n" + rows, ":1: #: ", "5000009 characters");
  }

  @ParameterizedTest
  @ValueSource(strings = {"NaN", "-90", "360", "1e9", "", "N", "90 deg", "90\u00b0"})
  void bearing_thatIsNone_isRefused(String bad) throws Exception {
    check(
        HEADER + "0,1\n" + bad + ",2\n180,3\n270,4\n",
        ":3: bearing_deg: ",
        "'" + bad + "' is not a bearing in [0, 360) degrees");
  }

  /** Bearings of the rows (threshold 1 each), line of the fault, problem. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 90 181 270 | 4 | found 181, expected 180 (even steps of 90 from 0)",
        "0 90 180 | 4 | 3 rows in steps of 90 degrees end at 180, expected a full turn of 4 rows",
        "0 90 180 270 359 | 6 | found 359, expected 360",
        "0 90 180 270 360 | 6 | '360' is not a bearing in [0, 360) degrees",
        "0 100 200 300 | 5 | 4 rows in steps of 100 degrees",
        "0 90 90 270 | 4 | bearing 90 appears twice",
        "0 0 90 180 | 3 | bearing 0 appears twice",
        "10 100 190 280 | 2 | found 10, expected 0",
        "270 180 90 0 | 2 | bearings fall; write the rows from bearing 0 upwards",
        "0 270 180 90 | 4 | found 180, expected 540",
        "0 0.5 1 1.6 | 5 | found 1.6, expected 1.5 (even steps of 0.5 from 0)"
      })
  void bearings_thatAreNotEven_areRefused(String bearings, int line, String problem)
      throws Exception {
    StringBuilder text = new StringBuilder(HEADER);
    for (String bearing : bearings.split(" ", -1)) {
      text.append(bearing).append(",1\n");
    }
    check(text.toString(), ":" + line + ": bearing_deg: ", problem);
  }

  @Test
  void columns_missing() throws Exception {
    check("bearing_deg,threshold\n0,1\n", ":1: threshold_m: ", "missing", "bearing_deg, threshold");
    check("# a: b\n\nBearing_deg,threshold_m\n0,1\n", ":3: bearing_deg: ", "column is missing");
    check("0,1\n90,2\n180,3\n", ":1: bearing_deg: ", "column is missing; found 0, 1");
  }

  @Test
  void columns_twice() throws Exception {
    check("bearing_deg,threshold_m,threshold_m\n0,1,1\n", ":1: threshold_m: ", "appears twice");
  }

  @Test
  void rows_ofAnotherLength() throws Exception {
    check(HEADER + "0,1\n90\n180,3\n", ":3: threshold_m: ", "1 field in the row, expected 2");
    check(HEADER + "0,1\n90,2,x\n", ":3: threshold_m: ", "3 fields in the row, expected 2");
    check(HEADER + "0,1\n90,2\n180,3\n270,4\nend of table\n", ":6: threshold_m: ", "1 field");
  }

  @Test
  void decimalCommas() throws Exception {
    check(HEADER + "0,1\n90,0,5\n", ":3: threshold_m: ", "decimal point");
    check(
        HEADER + "0,1\n90,\"0,5\"\n180,3\n270,4\n", ":3: threshold_m: ", "'0,5'", "decimal point");
  }

  /** As spreadsheets of half of Europe write it. */
  @ParameterizedTest
  @ValueSource(strings = {";", "\t", "|"})
  void otherSeparators(String separator) throws Exception {
    String text = "bearing_deg,threshold_m\n0,0.5\n90,0.5\n180,0.5\n270,0.5\n";
    check(text.replace(",", separator), ":1: ", "separated by commas");
    String decimalCommas = text.replace(",", separator).replace("0.5", "0,5");
    check(decimalCommas, ":1: ", "separated by commas", "decimal point");
    check("# unit: m\n" + decimalCommas, ":2: ", "separated by commas");
  }

  @Test
  void rows_missing() throws Exception {
    check("", ": ", "is empty");
    check("\n\n \n", ": ", "is empty");
    check("\uFEFF", ": ", "is empty");
    check("# provenance: measured\n", ": ", "is empty");
    check("bearing_deg,threshold_m", ": ", "0 rows, expected at least 3");
    check(HEADER + "0,1\n180,1\n", ": ", "2 rows, expected at least 3");
  }

  @Test
  void provenance_unknown() throws Exception {
    String rows = HEADER + "0,1\n120,2\n240,3\n";
    check(
        "# unit: m\n# provenance: guessed\n" + rows, ":2: provenance: ", "'guessed'", "predicted");
    check(
        "# provenance: Measured\n" + rows, ":1: provenance: ", "is not one of measured, captured");
    check("# provenance:\n" + rows, ":1: provenance: ", "''");
  }

  @Test
  void headerLine_twice() throws Exception {
    String rows = HEADER + "0,1\n120,2\n240,3\n";
    check(
        "# provenance: measured\n#provenance : captured\n" + rows,
        ":2: provenance: ",
        "'measured; captured'");
  }

  @Test
  void notAFile() throws Exception {
    Faults.check(TableFile::read, directory, ": ", "is a folder");
    Faults.check(TableFile::read, directory.resolve("none.csv"), ": ", "no such file");
    Files.createSymbolicLink(directory.resolve("link"), directory.resolve("gone"));
    Faults.check(TableFile::read, directory.resolve("link"), ": ", "no such file");
  }

  /** Reading /dev/zero would fill the memory, reading a pipe would wait for ever. */
  @ParameterizedTest
  @ValueSource(strings = {"/dev/zero", "/dev/null"})
  void deviceInsteadOfAFile(String device) {
    assertTimeoutPreemptively(
        Duration.ofSeconds(20),
        () -> Faults.check(TableFile::read, Path.of(device), ": ", "is not a regular file"));
  }

  /** A file that is there and may be opened, but not read: as root, too. */
  @Test
  void fileThatCannotBeRead() {
    Path memory = Path.of("/proc/self/mem");
    Faults.check(TableFile::read, memory, ": ", "cannot be read");
  }

  @Test
  void fileThatMayNotBeRead() throws Exception {
    Path file = Faults.file(directory, HEADER);
    assertTrue(file.toFile().setReadable(false));
    // Root reads it all the same, and then finds that it holds no rows.
    String expected = Files.isReadable(file) ? "0 rows" : "permission denied";
    Faults.check(TableFile::read, file, ": ", expected);
  }

  @Test
  void notUtf8() throws Exception {
    byte[] latin =
        "# object: Rohr f\u00fcr\nbearing_deg,threshold_m\n0,1\n"
            .getBytes(StandardCharsets.ISO_8859_1);
    Faults.check(TableFile::read, Faults.file(directory, latin), ": ", "is not UTF-8 text");
    byte[] utf16 = HEADER.getBytes(StandardCharsets.UTF_16);
    Faults.check(TableFile::read, Faults.file(directory, utf16), ": ", "is not UTF-8 text");
  }

  @Test
  void binaryGarbage() throws Exception {
    for (int seed = 0; seed < 50; seed++) {
      byte[] bytes = new byte[3000];
      new Random(seed).nextBytes(bytes);
      Faults.check(TableFile::read, Faults.file(directory, bytes), ":");
      for (int i = 0; i < bytes.length; i++) {
        bytes[i] &= 0x7f;
      }
      Faults.check(TableFile::read, Faults.file(directory, bytes), ":");
    }
  }

  /** No line break gets into a message by a quoted field, nor a terminal's control characters. */
  @Test
  void lineBreaksInFields() throws Exception {
    check("\"bearing\ndeg\",threshold_m\n0,1\n", ":1: bearing_deg: ", "missing");
    check("\"a\nb\",\"a\nb\"\n", ":1: ", "twice");
    check(HEADER + "0,\"1\n\u2028\u001b[31m2\"\n120,1\n240,1\n", ":2: threshold_m: ");
    check(HEADER + "0,\"1\n120,1\n240,1\n", ":2: threshold_m: ");
  }

  @Test
  void longFields_areCutAndTakeNoTime() {
    assertTimeoutPreemptively(
        Duration.ofSeconds(20),
        () -> {
          String digits = "1".repeat(300_000);
          check(HEADER + "0," + digits + "x\n120,1\n240,1\n", ":2: threshold_m: ", "...");
          check(digits + "\n", ":1: bearing_deg: ", "...");
          check(digits + "," + digits + "\n", ":1: ", "...");
          check(HEADER + ",".repeat(300_000) + "\n", ": ", "line 2", "fields");
        });
  }
}
