package simbad.experiments.dataset;

import java.util.Optional;
import java.util.OptionalInt;
import simbad.sonar.format.DataFormatException;

/** Options that are a column with its unit, or one value for all rows: {@code d}, {@code 30cm}. */
final class LogFigures {
  private static final double COLDEST = -273.15;

  private final LogTable log;
  private final LogSettings settings;
  private final Assumptions assumptions;

  LogFigures(LogTable log, LogSettings settings, Assumptions assumptions) {
    this.log = log;
    this.settings = settings;
    this.assumptions = assumptions;
  }

  /**
   * Finds a length.
   *
   * @param option that says it
   * @param unitOption that says its unit, where the column's name does not
   * @param least smallest number that is no slip
   */
  Optional<LoggedFigure> length(String option, String unitOption, double least)
      throws DataFormatException {
    if (!settings.has(option)) {
      return Optional.empty();
    }
    OptionalInt column = column(option, Unit.Kind.LENGTH);
    if (column.isEmpty()) {
      return Optional.of(constant(option, Unit.M));
    }
    return Optional.of(
        LoggedFigure.column(column.getAsInt(), lengthUnit(column.getAsInt(), unitOption), least));
  }

  private Unit lengthUnit(int column, String option) throws DataFormatException {
    if (settings.has(option)) {
      return unit(option, Unit.Kind.LENGTH);
    }
    Optional<Unit> named = Unit.inName(log.names().get(column));
    if (named.filter(unit -> unit.kind() == Unit.Kind.LENGTH).isPresent()) {
      return named.get();
    }
    Optional<Unit> own = log.findNumber(0, column).flatMap(LogNumber::unit);
    Optional<Unit> ranges = settings.find("range-unit").flatMap(Unit::find);
    Optional<Unit> unit = own.isPresent() ? own : ranges;
    if (unit.filter(is -> is.kind() == Unit.Kind.LENGTH).isEmpty()) {
      throw LogSettings.fault(
          option,
          "is missing: cm, mm, m or in; saw column "
              + log.names().get(column)
              + ": "
              + log.text(0, column));
    }
    if (own.isEmpty()) {
      assumptions.add(
          "Column '"
              + log.names().get(column)
              + "' is in "
              + unit.get().word()
              + ", as the ranges are (--"
              + option
              + ").");
    }
    return unit.get();
  }

  /** Finds an angle in degrees, counter-clockwise positive. */
  Optional<LoggedFigure> angle(String option) throws DataFormatException {
    if (!settings.has(option)) {
      return Optional.empty();
    }
    int way = settings.word("angle-positive", "ccw", "cw").equals("cw") ? -1 : 1;
    OptionalInt column = column(option, Unit.Kind.ANGLE);
    if (column.isEmpty()) {
      return Optional.of(constant(option, Unit.DEG).turned(way, 0));
    }
    if (!settings.has("angle-positive")) {
      assumptions.add(
          "Angles are positive counter-clockwise, seen from above (--angle-positive cw).");
    }
    Unit unit = Unit.DEG;
    Optional<Unit> named = Unit.inName(log.names().get(column.getAsInt()));
    if (settings.has("angle-unit")) {
      unit = unit("angle-unit", Unit.Kind.ANGLE);
    } else if (named.filter(is -> is.kind() == Unit.Kind.ANGLE).isPresent()) {
      unit = named.get();
    } else {
      assumptions.add(
          "Column '" + log.names().get(column.getAsInt()) + "' is in degrees (--angle-unit).");
    }
    return Optional.of(
        LoggedFigure.column(column.getAsInt(), unit, -LoggedFigure.GREATEST).turned(way, 0));
  }

  /** Finds a duration; numbers are milliseconds. */
  Optional<LoggedFigure> duration(String option) throws DataFormatException {
    return plain(option, Unit.MS, 0);
  }

  /** Finds a temperature in degrees Celsius. */
  Optional<LoggedFigure> temperature(String option) throws DataFormatException {
    return plain(option, Unit.CELSIUS, COLDEST);
  }

  private Optional<LoggedFigure> plain(String option, Unit unit, double least)
      throws DataFormatException {
    if (!settings.has(option)) {
      return Optional.empty();
    }
    OptionalInt column = column(option, unit.kind());
    return Optional.of(
        column.isPresent()
            ? LoggedFigure.column(column.getAsInt(), unit, least)
            : atLeast(option, constant(option, unit), least));
  }

  private static LoggedFigure atLeast(String option, LoggedFigure figure, double least)
      throws DataFormatException {
    boolean hot = figure.unit().kind() == Unit.Kind.TEMPERATURE;
    if (!(figure.constant() >= least && (!hot || figure.constant() <= LoggedFigure.HOTTEST_C))) {
      throw LogSettings.fault(
          option, figure.constant() + " is not in [" + least + ", " + LoggedFigure.HOTTEST_C + "]");
    }
    return figure;
  }

  /** Finds the column of an option that can be nothing else. */
  OptionalInt findColumn(String option) throws DataFormatException {
    Optional<String> word = settings.find(option);
    return word.isPresent()
        ? OptionalInt.of(LogColumns.require(log, word.get()))
        : OptionalInt.empty();
  }

  /** Returns the unit that an option names. */
  Unit unit(String option, Unit.Kind... kinds) throws DataFormatException {
    String word = settings.find(option).orElse("");
    Optional<Unit> unit = Unit.find(word);
    String known = "";
    for (Unit.Kind kind : kinds) {
      known += (known.isEmpty() ? "" : ", ") + Unit.words(kind);
      if (unit.isPresent() && unit.get().kind() == kind) {
        return unit.get();
      }
    }
    throw LogSettings.fault(option, "'" + word + "' is not one of " + known);
  }

  /** Empty where a value with its unit stands for all rows. */
  private OptionalInt column(String option, Unit.Kind kind) throws DataFormatException {
    String word = settings.find(option).orElse("");
    OptionalInt column = LogColumns.find(log, word);
    boolean value = LogNumber.find(word.strip(), false).flatMap(LogNumber::unit).isPresent();
    if (column.isEmpty() && !value) {
      throw LogSettings.fault(
          option,
          "'"
              + word
              + "' is neither a column nor a value with its unit, such as "
              + example(kind)
              + "; found "
              + log.shown());
    }
    return column;
  }

  private static String example(Unit.Kind kind) {
    return switch (kind) {
      case LENGTH -> "30cm";
      case TIME -> "60ms";
      case ANGLE -> "30deg";
      case TEMPERATURE -> "20c";
    };
  }

  private LoggedFigure constant(String option, Unit si) throws DataFormatException {
    String text = settings.find(option).orElse("");
    double value = LogSettings.measure(option, text, si.kind());
    if (!(Math.abs(value) <= LoggedFigure.GREATEST)) {
      throw LogSettings.fault(option, "'" + text + "' is too large");
    }
    return LoggedFigure.constant(value, si);
  }
}
