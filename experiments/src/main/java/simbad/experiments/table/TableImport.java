package simbad.experiments.table;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import simbad.sonar.check.Checks;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TextFile;
import simbad.sonar.shape.ThresholdTable;

/**
 * Threshold tables as others write them: other column names, other units, any even spacing, rows in
 * any order, bearings that grow clockwise.
 *
 * @param bearingColumn its name; empty to look for a usual one
 * @param thresholdColumn its name; empty to look for a usual one
 * @param unit of the thresholds; empty to take it from the column's name, else metres
 * @param clockwise whether bearings grow clockwise as seen from above
 * @param offsetDeg bearing here of the file's bearing 0
 */
public record TableImport(
    Optional<String> bearingColumn,
    Optional<String> thresholdColumn,
    Optional<Unit> unit,
    boolean clockwise,
    double offsetDeg) {
  /** Checks the offset. */
  public TableImport {
    Checks.finite("offsetDeg", offsetDeg);
  }

  /** Units of length. */
  public enum Unit {
    /** Metres. */
    M(1),
    /** Centimetres. */
    CM(100),
    /** Millimetres. */
    MM(1000),
    /** Inches. */
    IN(1 / 0.0254);

    private final double perM;

    Unit(double perM) {
      this.perM = perM;
    }
  }

  private static final List<String> BEARINGS =
      List.of("bearing_deg", "bearing", "angle_deg", "angle", "degrees", "deg", "heading", "theta");
  private static final List<String> THRESHOLDS =
      List.of("threshold", "distance", "range", "dist", "max_range", "radius", "r");
  private static final double TURN_DEG = 360;
  private static final double SAME_DEG = 1e-3;

  /**
   * Reads a file.
   *
   * @param file csv with a header row
   * @param header lines that the table shall have beside those of the file, which lose to them
   * @throws DataFormatException naming file, line and column of the first fault
   */
  public TableDocument read(Path file, Map<String, String> header) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    String bearings = column(csv, bearingColumn, BEARINGS, "bearing");
    String thresholds = column(csv, thresholdColumn, THRESHOLDS, "threshold");
    TreeMap<Double, Integer> rows = rowsByBearing(csv, bearings);
    checkSpacing(csv, bearings, rows);
    double perM = unit.orElseGet(() -> unitOf(thresholds)).perM;
    double[] values = new double[rows.size()];
    int i = 0;
    for (int row : rows.values()) {
      values[i++] =
          csv.number(
                  row,
                  thresholds,
                  value -> ThresholdTable.isThreshold(value / perM),
                  "a distance in [0, " + ThresholdTable.GREATEST_THRESHOLD_M + "] m")
              / perM;
    }
    Map<String, String> all = new LinkedHashMap<>(csv.header());
    all.keySet().removeIf(key -> key.isEmpty() || key.equals("unit") || key.equals("provenance"));
    all.putAll(header);
    all.put("unit", "m");
    return new TableDocument(ThresholdTable.of(values), all);
  }

  private static String column(
      CsvTable csv, Optional<String> named, List<String> usual, String what)
      throws DataFormatException {
    if (named.isPresent()) {
      csv.requireColumns(named.get());
      return named.get();
    }
    for (String stem : usual) {
      for (String column : csv.columns()) {
        if (plain(column).equals(stem)) {
          return column;
        }
      }
    }
    throw DataFormatException.inFile(
        csv.file(),
        "no column has a known name for the "
            + what
            + "; found "
            + String.join(", ", csv.columns())
            + " (name it with --"
            + what
            + ")");
  }

  /** In small letters and without its unit. */
  private static String plain(String column) {
    return column
        .toLowerCase(Locale.ROOT)
        .strip()
        .replaceAll("[\\s\\[(_]+(mm|cm|m|in|inch|inches|deg|degrees|°)[\\])]*$", "");
  }

  /** Whole degrees without a point. */
  private static String plain(double degrees) {
    return degrees == Math.rint(degrees) ? Long.toString((long) degrees) : Double.toString(degrees);
  }

  private static Unit unitOf(String column) {
    String name = column.toLowerCase(Locale.ROOT);
    for (Unit unit : List.of(Unit.CM, Unit.MM, Unit.IN)) {
      if (name.matches(".*[\\s\\[(_]" + unit.name().toLowerCase(Locale.ROOT) + "[\\])]*")) {
        return unit;
      }
    }
    return Unit.M;
  }

  private TreeMap<Double, Integer> rowsByBearing(CsvTable csv, String column)
      throws DataFormatException {
    TreeMap<Double, Integer> rows = new TreeMap<>();
    for (int row = 0; row < csv.size(); row++) {
      double written = csv.number(row, column, deg -> Math.abs(deg) <= 1e4, "a bearing in degrees");
      double turned = (clockwise ? -written : written) + offsetDeg;
      // To a thousandth, so that 359.99999 and 0 are one.
      double deg = Math.rint((turned - TURN_DEG * Math.floor(turned / TURN_DEG)) * 1e6) / 1e6;
      double bearing = deg >= TURN_DEG - SAME_DEG ? 0 : deg;
      boolean fullTurn = row == csv.size() - 1 && bearing == 0 && rows.containsKey(0.0);
      if (!fullTurn && rows.put(bearing, row) != null) {
        throw csv.fault(row, column, "bearing " + csv.text(row, column) + " appears twice");
      }
    }
    return rows;
  }

  private static void checkSpacing(CsvTable csv, String column, TreeMap<Double, Integer> rows)
      throws DataFormatException {
    if (rows.size() < ThresholdTable.LEAST_SIZE) {
      throw DataFormatException.inFile(
          csv.file(), rows.size() + " bearings, expected at least " + ThresholdTable.LEAST_SIZE);
    }
    double spacing = TURN_DEG / rows.size();
    int i = 0;
    for (Map.Entry<Double, Integer> row : rows.entrySet()) {
      double expected = i++ * spacing;
      if (Math.abs(row.getKey() - expected) > SAME_DEG) {
        throw csv.fault(
            row.getValue(),
            column,
            String.format(
                Locale.ROOT,
                "found %s where %d even steps of a full turn from 0 have %s",
                plain(row.getKey()),
                rows.size(),
                plain(expected)));
      }
    }
  }
}
