package simbad.experiments.dataset;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;

/**
 * A row of somebody's readings while it is mended; fields that nothing changes stay as they are.
 */
final class MendedRow {
  /** Of metres, degrees and seconds: finer than any of them is measured. */
  private static final int DECIMALS = 6;

  private final CsvTable csv;
  private final int row;
  private final List<String> fields = new ArrayList<>();

  MendedRow(CsvTable csv, int row) {
    this.csv = csv;
    this.row = row;
    csv.columns().forEach(column -> fields.add(csv.text(row, column)));
  }

  List<String> fields() {
    return List.copyOf(fields);
  }

  String text(String column) {
    return fields.get(at(column));
  }

  private int at(String column) {
    return csv.columns().indexOf(column);
  }

  void set(String column, String text) {
    fields.set(at(column), text);
  }

  void set(String column, double value) {
    BigDecimal rounded = new BigDecimal(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    set(column, rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString());
  }

  /** As it stands in the file, or as a step before has left it. */
  double number(String column) throws DataFormatException {
    try {
      double value = Double.parseDouble(text(column));
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // Said below.
    }
    throw csv.fault(
        row,
        column,
        "'" + text(column) + "' is not a finite number (empty, or one of --no-echo, for no echo)");
  }
}
