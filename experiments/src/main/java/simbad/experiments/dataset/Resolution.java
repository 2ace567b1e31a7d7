package simbad.experiments.dataset;

import java.util.List;
import simbad.sonar.format.DataFormatException;

/** In which steps ranges stand in a log, by the digits that are written. */
final class Resolution {
  /** Finer than any pulse tells. */
  private static final double LEAST_M = 5e-4;

  private Resolution() {}

  /**
   * Returns the step.
   *
   * @param logs the tables
   * @param ranges the columns that hold them
   * @param unit of the numbers
   * @return metres; 0 where times of flight are written, or more digits than matter
   */
  static double stepM(List<LogTable> logs, String ranges, Unit unit) throws DataFormatException {
    int decimals = 0;
    for (LogTable log : logs) {
      for (int column : LogColumns.list(log, ranges)) {
        for (int row = 0; row < log.size(); row++) {
          decimals = Math.max(decimals, decimals(log.text(row, column)));
        }
      }
    }
    double stepM = unit.si(1) / Math.pow(10, decimals);
    return unit.kind() == Unit.Kind.LENGTH && stepM >= LEAST_M ? stepM : 0;
  }

  /** Of a number in powers of ten as many as matter. */
  private static int decimals(String cell) {
    int point = Math.max(cell.indexOf('.'), cell.indexOf(','));
    int end = point + 1;
    while (point >= 0 && end < cell.length() && Character.isDigit(cell.charAt(end))) {
      end++;
    }
    return point < 0 ? 0 : end - point - 1;
  }
}
