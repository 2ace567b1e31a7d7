package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Rows of readings as csv files: {@code run,sensor,t_s,x_m,z_m,heading_deg,range_m}; an empty range
 * is a no-echo, further columns are ignored. In the second format some of them are read.
 */
public final class ReadingsFile {
  static final String RANGE = "range_m";
  static final String TIME = "t_s";
  static final String[] POSE_COLUMNS = {"run", "sensor", "t_s", "x_m", "z_m", "heading_deg"};

  /** Further than any sonar hears and longer ago than any log: what is more is a slip. */
  static final double GREATEST_M = 1e7;

  static final double GREATEST_DEG = 1e9;
  private static final double GREATEST_S = 1e12;

  private ReadingsFile() {}

  /**
   * Reads rows of the first format with their readings.
   *
   * @param file csv
   * @return the rows in the file's order; no two of one run and sensor have the same time
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> read(Path file) throws DataFormatException {
    return read(file, DataFormat.FIRST);
  }

  /**
   * Reads rows with their readings.
   *
   * @param file csv
   * @param format of the data set; in the second the column t_s may be missing, and placement,
   *     temperature_c, obstacle_x_m, obstacle_z_m, obstacle_turn_deg, gap_ms and pause_ms are read
   *     where they are there
   * @return the rows in the file's order; no two of one run and sensor have the same time, if they
   *     have one
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> read(Path file, DataFormat format) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(poseColumns(csv, format));
    csv.requireColumns(RANGE);
    List<ReadingRow> rows = rows(csv, format, true);
    if (csv.hasColumn(TIME)) {
      requireDistinctTimes(csv, rows);
    }
    return rows;
  }

  private static String[] poseColumns(CsvTable csv, DataFormat format) {
    boolean timeless = format == DataFormat.SECOND && !csv.hasColumn(TIME);
    return Stream.of(POSE_COLUMNS)
        .filter(column -> !(timeless && column.equals(TIME)))
        .toArray(String[]::new);
  }

  /**
   * Reads rows of the first format whose readings are absent or of no interest.
   *
   * @param file csv; a column range_m may be missing, what stands in it is ignored
   * @return the rows in the file's order; each reads no echo
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> readPoses(Path file) throws DataFormatException {
    return readPoses(file, DataFormat.FIRST);
  }

  /**
   * Reads rows whose readings are absent or of no interest.
   *
   * @param file csv; a column range_m may be missing, what stands in it is ignored
   * @param format of the data set, as for {@link #read(Path, DataFormat)}
   * @return the rows in the file's order; each reads no echo
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<ReadingRow> readPoses(Path file, DataFormat format)
      throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(poseColumns(csv, format));
    return rows(csv, format, false);
  }

  private static List<ReadingRow> rows(CsvTable csv, DataFormat format, boolean withRange)
      throws DataFormatException {
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
              csv.hasColumn(TIME) ? within(GREATEST_S, csv, row, TIME) : 0,
              pose,
              withRange ? reading(csv, row) : NoEcho.NO_ECHO,
              format == DataFormat.SECOND
                  ? CircumstanceColumns.read(csv, row)
                  : Circumstances.NONE));
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

  static double within(double greatest, CsvTable csv, int row, String column)
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
                + " is in line "
                + csv.line(before)
                + " already, for the same run and sensor");
      }
    }
  }
}
