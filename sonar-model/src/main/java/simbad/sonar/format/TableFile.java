package simbad.sonar.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/**
 * Threshold tables as csv files: columns {@code bearing_deg,threshold_m}, any even spacing from
 * bearing 0, {@code # key: value} lines above. The ends of an uncertainty band may stand in {@code
 * threshold_low_m,threshold_high_m}.
 */
public final class TableFile {
  private static final String BEARING = "bearing_deg";
  private static final String THRESHOLD = "threshold_m";
  private static final String LOW = "threshold_low_m";
  private static final String HIGH = "threshold_high_m";
  private static final double TURN_DEG = 360;
  private static final double SAME_BEARING_DEG = 1e-6;

  private TableFile() {}

  /**
   * Reads a table.
   *
   * @param file csv; a byte order mark and CRLF line ends are accepted
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static TableDocument read(Path file) throws DataFormatException {
    return parse(file, TextFile.read(file));
  }

  /**
   * Reads a table from a text that was read already.
   *
   * @param name how messages name the text
   * @param text csv
   * @throws DataFormatException naming name, line and field of the first fault
   */
  public static TableDocument parse(Path name, String text) throws DataFormatException {
    CsvTable csv = CsvTable.parse(name, text);
    csv.requireColumns(BEARING, THRESHOLD);
    double[] thresholds = thresholds(csv, THRESHOLD);
    checkBearings(csv);
    return new TableDocument(ThresholdTable.of(thresholds), header(csv), band(csv));
  }

  private static double[] thresholds(CsvTable csv, String column) throws DataFormatException {
    double[] thresholds = new double[csv.size()];
    for (int row = 0; row < thresholds.length; row++) {
      thresholds[row] =
          csv.number(
              row,
              column,
              ThresholdTable::isThreshold,
              "a distance in [0, " + ThresholdTable.GREATEST_THRESHOLD_M + "] m");
    }
    return thresholds;
  }

  private static Optional<ThresholdBand> band(CsvTable csv) throws DataFormatException {
    if (!csv.hasColumn(LOW) || !csv.hasColumn(HIGH)) {
      return Optional.empty();
    }
    double[] low = thresholds(csv, LOW);
    double[] high = thresholds(csv, HIGH);
    for (int row = 0; row < low.length; row++) {
      if (low[row] > high[row]) {
        throw csv.fault(row, LOW, low[row] + " is above " + HIGH + " = " + high[row]);
      }
    }
    return Optional.of(new ThresholdBand(ThresholdTable.of(low), ThresholdTable.of(high)));
  }

  private static void checkBearings(CsvTable csv) throws DataFormatException {
    if (csv.size() < ThresholdTable.LEAST_SIZE) {
      throw DataFormatException.inFile(
          csv.file(),
          csv.size() + " rows, expected at least " + ThresholdTable.LEAST_SIZE + " bearings");
    }
    double spacing = bearing(csv, 1) - bearing(csv, 0);
    if (spacing < 0) {
      throw csv.fault(0, BEARING, "bearings fall; write the rows from bearing 0 upwards");
    }
    for (int row = 0; row < csv.size(); row++) {
      double expected = row * spacing;
      double found = bearing(csv, row);
      if (row > 0 && Math.abs(found - bearing(csv, row - 1)) < SAME_BEARING_DEG) {
        throw csv.fault(row, BEARING, "bearing " + degrees(found) + " appears twice");
      }
      if (!(Math.abs(found - expected) < SAME_BEARING_DEG)) {
        throw csv.fault(
            row,
            BEARING,
            "found "
                + degrees(found)
                + ", expected "
                + degrees(expected)
                + " (even steps of "
                + degrees(spacing)
                + " from 0)");
      }
    }
    checkFullTurn(csv, spacing);
  }

  private static void checkFullTurn(CsvTable csv, double spacing) throws DataFormatException {
    double turn = csv.size() * spacing;
    if (!(Math.abs(turn - TURN_DEG) < csv.size() * SAME_BEARING_DEG)) {
      int last = csv.size() - 1;
      throw csv.fault(
          last,
          BEARING,
          csv.size()
              + " rows in steps of "
              + degrees(spacing)
              + " degrees end at "
              + degrees(bearing(csv, last))
              + ", expected a full turn of "
              + degrees(Math.rint(TURN_DEG / spacing))
              + " rows");
    }
  }

  private static double bearing(CsvTable csv, int row) throws DataFormatException {
    return csv.number(
        row,
        BEARING,
        degrees -> degrees >= 0 && degrees < TURN_DEG,
        "a bearing in [0, 360) degrees");
  }

  private static String degrees(double value) {
    return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
  }

  /** What stands in two lines of one key is joined, so that nothing is lost. */
  private static Map<String, String> header(CsvTable csv) throws DataFormatException {
    Map<String, String> header = new LinkedHashMap<>();
    for (CsvTable.Comment comment : csv.comments()) {
      int colon = Math.max(0, comment.text().indexOf(':'));
      String key = comment.text().substring(0, colon).strip();
      if (!key.isEmpty()) {
        String value = comment.text().substring(colon + 1).strip();
        checkProvenance(csv, comment.line(), key, header.merge(key, value, (a, b) -> a + "; " + b));
      }
    }
    return header;
  }

  private static void checkProvenance(CsvTable csv, long line, String key, String value)
      throws DataFormatException {
    if (key.equals(TableDocument.PROVENANCE) && Provenance.find(value).isEmpty()) {
      throw csv.fault(line, key, "'" + value + "' is not one of " + Provenance.words());
    }
  }

  /**
   * Writes a table so that {@link #read} gives it back.
   *
   * @param file target; its directory must exist
   * @param document table and header lines
   * @throws IOException if it cannot be written
   */
  public static void write(Path file, TableDocument document) throws IOException {
    TextFile.write(file, text(document));
  }

  /**
   * Returns a table as the text of a file.
   *
   * @param document table and header lines
   */
  public static String text(TableDocument document) {
    StringBuilder text = new StringBuilder();
    document.header().forEach((key, value) -> text.append("# " + key + ": " + value + "\n"));
    text.append(BEARING + "," + THRESHOLD);
    document.band().ifPresent(band -> text.append("," + LOW + "," + HIGH));
    text.append('\n');
    ThresholdTable table = document.table();
    for (int i = 0; i < table.size(); i++) {
      // Multiplied before it is divided: 72 rows then stand at whole degrees to the last digit.
      text.append(degrees(i * TURN_DEG / table.size()) + "," + table.valueM(i));
      int row = i;
      document
          .band()
          .ifPresent(
              band -> text.append("," + band.low().valueM(row) + "," + band.high().valueM(row)));
      text.append('\n');
    }
    return text.toString();
  }
}
