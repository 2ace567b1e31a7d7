package simbad.experiments.dataset;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A number as it stands in a cell or on a command line, perhaps with a unit behind it.
 *
 * @param value finite
 * @param unit empty where it has none
 */
record LogNumber(double value, Optional<Unit> unit) {
  /** No digit can belong to two parts of it: refusing a long one takes no time. */
  private static final Pattern NUMBER =
      Pattern.compile(
          "([+-]?(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?)\\s*([^\\s\\d.,;:+-][^\\s\\d]*)?");

  private static final int LONGEST = 100;

  /**
   * Reads a number.
   *
   * @param text without blanks round it
   * @param decimalComma whether a comma stands for the point
   * @return empty if it is none, or has something behind it that is no unit
   */
  static Optional<LogNumber> find(String text, boolean decimalComma) {
    if (text.isEmpty() || text.length() > LONGEST) {
      return Optional.empty();
    }
    Matcher number = NUMBER.matcher(decimalComma ? text.replace(',', '.') : text);
    if (!number.matches()) {
      return Optional.empty();
    }
    double value = Double.parseDouble(number.group(1));
    String behind = number.group(2);
    if (!Double.isFinite(value) || behind == null) {
      return Double.isFinite(value)
          ? Optional.of(new LogNumber(value, Optional.empty()))
          : Optional.empty();
    }
    return Unit.find(behind).map(unit -> new LogNumber(value, Optional.of(unit)));
  }
}
