package simbad.experiments.dataset;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.sonar.format.DataFormatException;

/**
 * A quantity of each row: a column with its unit, or the same value in all of them.
 *
 * @param column empty for a constant
 * @param unit of the column's numbers; of a constant its own
 * @param constant in the SI unit, or degrees; what is added to a column's
 * @param least smallest number that is no slip, in the column's unit
 * @param origin number of the column that counts as 0
 * @param sign -1 for a column that counts the other way round, else 1
 */
record LoggedFigure(
    OptionalInt column, Unit unit, double constant, double least, double origin, int sign) {
  /** In millimetres ten kilometres: what is more is a slip. */
  static final double GREATEST = 1e7;

  static LoggedFigure constant(double value, Unit si) {
    return new LoggedFigure(OptionalInt.empty(), si, value, -GREATEST, 0, 1);
  }

  static LoggedFigure column(int column, Unit unit, double least) {
    return new LoggedFigure(OptionalInt.of(column), unit, 0, least, 0, 1);
  }

  /** Returns the same with another number as 0. */
  LoggedFigure from(double number) {
    return new LoggedFigure(column, unit, constant, least, number, sign);
  }

  /** Returns the same counted the other way round, and something added. */
  LoggedFigure turned(int way, double added) {
    return column.isEmpty()
        ? constant(way * constant + added, unit)
        : new LoggedFigure(column, unit, added, least, origin, way);
  }

  /**
   * Reads it.
   *
   * @param log the table
   * @param row of it
   * @return in the SI unit, or degrees; empty where the cell is
   * @throws DataFormatException if something else stands there
   */
  OptionalDouble of(LogTable log, int row) throws DataFormatException {
    if (column.isEmpty()) {
      return OptionalDouble.of(constant);
    }
    int at = column.getAsInt();
    if (log.text(row, at).isEmpty()) {
      requireWhole(log, row, at);
      return OptionalDouble.empty();
    }
    Optional<LogNumber> number = log.findNumber(row, at);
    Unit own = number.flatMap(LogNumber::unit).orElse(unit);
    if (number.isEmpty()
        || own.kind() != unit.kind()
        || !(number.get().value() >= least && Math.abs(number.get().value()) <= GREATEST_OF_ANY)
        || number.get().value() > most()) {
      throw log.fault(row, at, "'" + log.text(row, at) + "' is not a number" + bounds());
    }
    return OptionalDouble.of(sign * own.si(number.get().value() - origin) + constant);
  }

  /** As readings may have it. */
  static final double HOTTEST_C = 1000;

  /** A clock in nanoseconds counts far. */
  private static final double GREATEST_OF_ANY = 1e21;

  private double most() {
    return switch (unit.kind()) {
      case TIME -> GREATEST_OF_ANY;
      case TEMPERATURE -> HOTTEST_C;
      default -> GREATEST;
    };
  }

  private String bounds() {
    return (least >= 0 ? " of at least 0," : "") + " at most " + most();
  }

  static void requireWhole(LogTable log, int row, int column) throws DataFormatException {
    if (log.isCut(row, column)) {
      throw log.fault(
          row, column, "the row ends before this column (--skip-bad leaves such rows out)");
    }
  }
}
