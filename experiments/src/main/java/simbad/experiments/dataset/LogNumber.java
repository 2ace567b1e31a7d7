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

  /** Digits in threes behind a first group that does not begin with 0, and what follows them. */
  private static final Pattern THOUSANDS =
      Pattern.compile(
          "([+-]?[1-9]\\d{0,2})((?:([,.' \u2019\u00a0\u202f])\\d{3})(?:\\3\\d{3})*)(?!\\d)(.*)");

  private static final int LONGEST = 100;

  /**
   * Reads a number. Marks between thousands are left out: a blank, an apostrophe, and of comma and
   * point the one that is not the decimal mark.
   *
   * @param text without blanks round it
   * @param decimalComma whether a comma stands for the point
   * @return empty if it is none, or has something behind it that is no unit
   */
  static Optional<LogNumber> find(String text, boolean decimalComma) {
    if (text.isEmpty() || text.length() > LONGEST) {
      return Optional.empty();
    }
    String plain = ungrouped(text, decimalComma ? ',' : '.');
    Matcher number = NUMBER.matcher(decimalComma ? plain.replace(',', '.') : plain);
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

  private static String ungrouped(String text, char decimal) {
    Matcher grouped = THOUSANDS.matcher(text);
    if (!grouped.matches() || grouped.group(3).charAt(0) == decimal) {
      return text;
    }
    return grouped.group(1) + grouped.group(2).replace(grouped.group(3), "") + grouped.group(4);
  }

  /** Tells whether a cell is digits in threes with a mark between: thousands, or three decimals. */
  static boolean isGrouped(String text, char mark) {
    Matcher grouped = THOUSANDS.matcher(text);
    return grouped.matches()
        && grouped.group(3).charAt(0) == mark
        && (grouped.group(4).isEmpty() || ",.".indexOf(grouped.group(4).charAt(0)) >= 0);
  }
}
