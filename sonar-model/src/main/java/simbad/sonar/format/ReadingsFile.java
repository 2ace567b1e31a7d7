package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Rows of readings as csv files: {@code run,sensor,t_s,x_m,z_m,heading_deg,range_m}; an empty range
 * is a no-echo, further columns are ignored.
 */
public final class ReadingsFile {
  private static final String RANGE = "range_m";
  private static final String[] POSE_COLUMNS = {
    "run", "sensor", "t_s", "x_m", "z_m", "heading_deg"
  };

  private ReadingsFile() {}

  /**
   * Reads rows with their readings.
   *
   * @param file csv
   * @return the rows in the file's order
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> read(Path file) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(POSE_COLUMNS);
    csv.requireColumns(RANGE);
    return rows(csv, true);
  }

  /**
   * Reads rows whose readings are absent or of no interest.
   *
   * @param file csv; a column range_m may be missing, what stands in it is ignored
   * @return the rows in the file's order; each reads no echo
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> readPoses(Path file) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(POSE_COLUMNS);
    return rows(csv, false);
  }

  private static List<ReadingRow> rows(CsvTable csv, boolean withRange) throws DataFormatException {
    List<ReadingRow> rows = new ArrayList<>(csv.size());
    for (int row = 0; row < csv.size(); row++) {
      Pose pose =
          Pose.of(
              finite(csv, row, "x_m"),
              finite(csv, row, "z_m"),
              Math.toRadians(finite(csv, row, "heading_deg")));
      rows.add(
          new ReadingRow(
              csv.text(row, "run"),
              csv.text(row, "sensor"),
              finite(csv, row, "t_s"),
              pose,
              withRange ? reading(csv, row) : NoEcho.NO_ECHO));
    }
    return List.copyOf(rows);
  }

  private static Reading reading(CsvTable csv, int row) throws DataFormatException {
    if (csv.text(row, RANGE).isEmpty()) {
      return NoEcho.NO_ECHO;
    }
    return new Echo(
        csv.number(
            row,
            RANGE,
            range -> range >= 0 && range < Double.POSITIVE_INFINITY,
            "a range of at least 0 m (empty for a no-echo)"));
  }

  private static double finite(CsvTable csv, int row, String column) throws DataFormatException {
    return csv.number(
        row, column, value -> Math.abs(value) < Double.POSITIVE_INFINITY, "a finite number");
  }
}
