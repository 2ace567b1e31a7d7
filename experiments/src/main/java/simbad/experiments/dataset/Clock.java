package simbad.experiments.dataset;

import java.time.DateTimeException;
import java.time.LocalDateTime;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import java.util.OptionalDouble;
import simbad.sonar.format.DataFormatException;

/** When the pings of a log were. */
interface Clock {
  /** Nobody knows. */
  Clock NONE = (log, row, taken) -> OptionalDouble.empty();

  /**
   * Returns the time of a row.
   *
   * @param log the table
   * @param row of it
   * @param taken rows that were taken before
   * @return seconds; empty where it is not known
   * @throws DataFormatException if the log says something else there
   */
  OptionalDouble timeS(LogTable log, int row, int taken) throws DataFormatException;

  /** A ping for every row of the log, those too that are not taken. */
  static Clock ofRows(double periodS) {
    return (log, row, taken) -> OptionalDouble.of(row * periodS);
  }

  /** A ping for every reading that is taken. */
  static Clock ofTaken(double periodS) {
    return (log, row, taken) -> OptionalDouble.of(taken * periodS);
  }

  /** A column of numbers, or of dates and times of day; such count from the first row on. */
  static Clock of(LogTable first, int column, Unit unit) throws DataFormatException {
    if (first.findNumber(0, column).isPresent()) {
      LoggedFigure time = LoggedFigure.column(column, unit, -Double.MAX_VALUE);
      return (log, row, taken) -> {
        OptionalDouble at = time.of(log, row);
        if (at.isEmpty()) {
          throw log.fault(row, column, "is empty, expected a time");
        }
        return at;
      };
    }
    LocalDateTime start = date(first, 0, column);
    return (log, row, taken) ->
        OptionalDouble.of(ChronoUnit.MICROS.between(start, date(log, row, column)) / 1e6);
  }

  private static LocalDateTime date(LogTable log, int row, int column) throws DataFormatException {
    String text = log.text(row, column).replace(',', '.');
    try {
      if (text.indexOf('-') < 0 && text.indexOf('/') < 0) {
        return LocalTime.parse(text).atDate(java.time.LocalDate.EPOCH);
      }
      String iso = text.replace('/', '-').replaceFirst("[T ]+", "T");
      return iso.matches(".*(Z|[+-]\\d\\d:?\\d\\d)$") && iso.indexOf('T') > 0
          ? LocalDateTime.ofInstant(
              java.time.OffsetDateTime.parse(iso.replaceFirst("([+-]\\d\\d)(\\d\\d)$", "$1:$2"))
                  .toInstant(),
              ZoneOffset.UTC)
          : LocalDateTime.parse(iso);
    } catch (DateTimeException e) {
      throw log.fault(
          row,
          column,
          "'"
              + log.text(row, column)
              + "' is neither a number nor a time such as"
              + " 2021-03-04 12:00:01.5 or 12:00:01.5");
    }
  }
}
