package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
  static final String RANGE = "range_m";
  static final String[] POSE_COLUMNS = {"run", "sensor", "t_s", "x_m", "z_m", "heading_deg"};

  /** Further than any sonar hears and longer ago than any log: what is more is a slip. */
  private static final double GREATEST_M = 1e7;

  private static final double GREATEST_S = 1e12;
  private static final double GREATEST_DEG = 1e9;

  private ReadingsFile() {}

  /**
   * Reads rows with their readings.
   *
   * @param file csv
   * @return the rows in the file's order; no two of one run and sensor have the same time
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> read(Path file) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(POSE_COLUMNS);
    csv.requireColumns(RANGE);
    List<ReadingRow> rows = rows(csv, true);
    requireDistinctTimes(csv, rows);
    return rows;
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
              within(GREATEST_M, csv, row, "x_m"),
              within(GREATEST_M, csv, row, "z_m"),
              Math.toRadians(within(GREATEST_DEG, csv, row, "heading_deg")));
      rows.add(
          new ReadingRow(
              csv.label(row, "run"),
              csv.label(row, "sensor"),
              within(GREATEST_S, csv, row, "t_s"),
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
            range -> range >= 0 && range <= GREATEST_M,
            "a range of at least 0 m (empty for a no-echo), at most " + GREATEST_M));
  }

  private static double within(double greatest, CsvTable csv, int row, String column)
      throws DataFormatException {
    return csv.number(
        row,
        column,
        value -> Math.abs(value) <= greatest,
        "a finite number of at most " + greatest);
  }

  /** Times order the rows of a run and sensor: two equal ones would leave that to chance. */
  private static void requireDistinctTimes(CsvTable csv, List<ReadingRow> rows)
      throws DataFormatException {
    record Ping(String run, String sensor, double timeS) {}
    Map<Ping, Integer> seen = new HashMap<>();
    for (int row = 0; row < rows.size(); row++) {
      ReadingRow one = rows.get(row);
      Integer before = seen.put(new Ping(one.run(), one.sensor(), one.timeS()), row);
      if (before != null) {
        throw csv.fault(
            row,
            "t_s",
            csv.text(row, "t_s")
                + " stands in line "
                + csv.line(before)
                + " already, for the same run and sensor");
      }
    }
  }
}
