package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class ReadingsFileTest {
  private static final String HEADER = "run,sensor,t_s,x_m,z_m,heading_deg,range_m\n";

  @TempDir private Path directory = Path.of("target");

  private List<ReadingRow> read(String text) throws Exception {
    return ReadingsFile.read(Faults.file(directory, text));
  }

  private void check(String text, String where, String... parts) throws Exception {
    Faults.check(ReadingsFile::read, Faults.file(directory, text), where, parts);
  }

  @Test
  void rows_areRead() throws Exception {
    List<ReadingRow> rows = read(Samples.READINGS);
    assertEquals(3, rows.size());
    Pose pose = Pose.of(1.5, -0.25, Math.PI / 2);
    assertEquals(new ReadingRow("a", "left", 0, pose, new Echo(0.42)), rows.get(0));
    assertEquals(NoEcho.NO_ECHO, rows.get(1).reading());
    assertEquals("r,1", rows.get(2).sensor());
    assertEquals(new Echo(0), rows.get(2).reading());
    assertEquals(Math.PI, rows.get(2).pose().heading().radians(), "-180 degrees is 180 degrees");
  }

  @ParameterizedTest
  @CsvSource({"run, 0", "sensor, 1"})
  void label_thatIsTooLongOrOnTwoLines_isRefused(String column, int field) throws Exception {
    String[] labels = {"r", "s"};
    labels[field] = "n".repeat(200);
    assertEquals(1, read(HEADER + String.join(",", labels) + ",0,0,0,0,1\n").size());
    labels[field] = "n".repeat(201);
    check(
        HEADER + String.join(",", labels) + ",0,0,0,0,1\n",
        ":2: " + column + ": ",
        "is not a name of at most 200 characters on one line");
    labels[field] = "\"a\nb\"";
    check(HEADER + String.join(",", labels) + ",0,0,0,0,1\n", ":2: " + column + ": 'a b' is not");
  }

  @Test
  void rows_areRead_howeverTheyAreWritten() throws Exception {
    List<ReadingRow> rows = read(Samples.READINGS);
    assertEquals(rows, read("\uFEFF" + Samples.READINGS.replace("\n", "\r\n")));
    assertEquals(rows, read("# by hand\n\n" + Samples.READINGS.replace(",0.42", " , 0.42 ")));
    assertEquals(
        rows, read(Samples.READINGS.replace("\n", ",\n").replace("range_m,", "range_m,x")));
    assertEquals(List.of(), read(HEADER));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0.42 | -0.01 | 2: range_m | '-0.01' is not a range of at least 0 m (empty for a no-echo)",
        "0.42 | NaN | 2: range_m | 'NaN' is not a range",
        "0.42 | inf | 2: range_m | 'inf' is not a range",
        "0.42 | 1e300 | 2: range_m | '1e300' is not a range",
        "-0.25 | 1e300 | 2: z_m | '1e300' is not a finite number of at most",
        "0.42 | 1e999 | 2: range_m | '1e999' is not a range",
        "0.42 | no echo | 2: range_m | 'no echo' is not a range",
        "0.42 | 0,42 | 2: range_m | 8 fields in the row, expected 7 (a number has a "
            + "decimal point",
        "0.00 | x | 2: t_s | 'x' is not a finite number",
        "0.00 | '' | 2: t_s | '' is not a finite number",
        "-0.25 | 1e999 | 2: z_m | '1e999' is not a finite number",
        "95 | 95 deg | 3: heading_deg | '95 deg' is not a finite number",
        "95, | 95 | 3: range_m | 6 fields in the row, expected 7",
        "x_m | x | 1: x_m | column is missing; found run, sensor, t_s, x, z_m",
        "range_m | range | 1: range_m | column is missing",
        "run, | . | 1: run | column is missing"
      })
  void field_spoiled_isNamed(String piece, String instead, String where, String part)
      throws Exception {
    String text = Samples.READINGS;
    int at = text.indexOf(piece);
    String spoiled =
        text.substring(0, at)
            + (instead.equals(".") ? "" : instead)
            + text.substring(at + piece.length());
    // A column less in the header makes the rows too long; that is another fault.
    String rows = instead.equals(".") ? spoiled.substring(0, spoiled.indexOf('\n') + 1) : spoiled;
    check(rows, ":" + where + ": ", part);
  }

  @Test
  void otherSeparators_areSaid() throws Exception {
    check(Samples.READINGS.replace(',', ';'), ":1: ", "separated by commas");
    check("", ": ", "is empty");
  }

  /** Poses to predict at: what stands in range_m does not matter, if there is such a column. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "run,sensor,t_s,x_m,z_m,heading_deg\na,left,0.00,1.5,-0.25,90\n",
        "run,sensor,t_s,x_m,z_m,heading_deg,range_m\na,left,0.00,1.5,-0.25,90,0.42\n",
        "run,sensor,t_s,x_m,z_m,heading_deg,range_m\na,left,0.00,1.5,-0.25,90,unknown\n"
      })
  void poses_areRead_whateverTheRange(String text) throws Exception {
    List<ReadingRow> rows = ReadingsFile.readPoses(Faults.file(directory, text));
    Pose pose = Pose.of(1.5, -0.25, Math.PI / 2);
    assertEquals(List.of(new ReadingRow("a", "left", 0, pose, NoEcho.NO_ECHO)), rows);
  }

  /** Also when the same time is written in two ways, and with other rows between. */
  @Test
  void timeOfOneSensor_twice_isNamed() throws Exception {
    Path file =
        Faults.file(
            directory,
            HEADER + "a,s,0.5,0,0,0,1\na,t,0.5,0,0,0,1\nb,s,0.5,0,0,0,1\na,s,0.50,0,0,0,1\n");
    Faults.check(ReadingsFile::read, file, ":5: t_s: ", "0.50 is in line 2 already");
  }

  @Test
  void poses_needAllOtherColumns() throws Exception {
    Path file = Faults.file(directory, "run,sensor,t_s,x_m,z_m\na,left,0,1,2\n");
    Faults.check(ReadingsFile::readPoses, file, ":1: heading_deg: ", "column is missing");
  }

  /** Numbers as Java writes them are read to the last digit. */
  @Seeded
  void numbers_comeBackExactly(@ForAll Random random) throws Exception {
    double x = random.nextGaussian() * Math.pow(10, random.nextInt(-12, 6));
    double range = random.nextDouble(0, 10);
    double headingDeg = random.nextDouble(-720, 720);
    Path file = Files.createTempFile(Path.of("target"), "rows", ".csv");
    try {
      TextFile.write(file, HEADER + "r,s," + x + "," + x + ",0," + headingDeg + "," + range + "\n");
      ReadingRow row = ReadingsFile.read(file).get(0);
      assertEquals(x, row.timeS());
      assertEquals(x, row.pose().position().xM());
      assertEquals(new Echo(range), row.reading());
      double off = Math.toRadians(headingDeg) - row.pose().heading().radians();
      assertTrue(Math.abs(Angles.signed(off)) < 1e-12);
    } finally {
      Files.delete(file);
    }
  }
}
