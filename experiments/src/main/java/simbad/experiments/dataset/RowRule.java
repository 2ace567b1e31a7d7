package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;

/**
 * Which rows of a log are taken, by one column.
 *
 * @param column by which
 * @param value that stands there, word by word; empty for a range of numbers
 * @param least of the range
 * @param most of the range
 * @param taken whether these rows are taken, or all others
 */
record RowRule(int column, Optional<String> value, double least, double most, boolean taken) {
  private static final String BETWEEN = "..";

  static RowRule word(int column, String value, boolean taken) {
    return new RowRule(column, Optional.of(value), 0, 0, taken);
  }

  static RowRule within(int column, double least, double most) {
    return new RowRule(column, Optional.empty(), least, most, true);
  }

  /** Reads the rules of {@code --only COLUMN=VALUE} and {@code --without COLUMN=VALUE}. */
  static List<RowRule> of(LogTable log, LogSettings settings) throws DataFormatException {
    List<RowRule> rules = new ArrayList<>();
    for (String rule : settings.all("only")) {
      rules.add(of(log, "only", rule, true));
    }
    for (String rule : settings.all("without")) {
      rules.add(of(log, "without", rule, false));
    }
    return rules;
  }

  private static RowRule of(LogTable log, String option, String rule, boolean taken)
      throws DataFormatException {
    int equals = rule.indexOf('=');
    if (equals < 1) {
      throw LogSettings.fault(option, "'" + rule + "' is not COLUMN=VALUE or COLUMN=LEAST..MOST");
    }
    int column = LogColumns.require(log, rule.substring(0, equals));
    String value = rule.substring(equals + 1);
    int dots = value.indexOf(BETWEEN);
    Optional<LogNumber> least =
        dots < 0 ? Optional.empty() : LogNumber.find(value.substring(0, dots).strip(), false);
    Optional<LogNumber> most =
        dots < 0 ? Optional.empty() : LogNumber.find(value.substring(dots + 2).strip(), false);
    return least.isPresent() && most.isPresent()
        ? new RowRule(column, Optional.empty(), least.get().value(), most.get().value(), taken)
        : word(column, value, taken);
  }

  /** Tells whether a row is taken. */
  boolean takes(LogTable log, int row) throws DataFormatException {
    if (value.isPresent()) {
      return log.text(row, column).equals(value.get()) == taken;
    }
    Optional<LogNumber> number = log.findNumber(row, column);
    if (number.isEmpty()) {
      throw log.fault(row, column, "'" + log.text(row, column) + "' is not a number");
    }
    double is = number.get().value();
    return (is >= least && is <= most) == taken;
  }
}
