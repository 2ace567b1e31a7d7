package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoublePredicate;
import simbad.sonar.format.DataFormatException;

/**
 * What stands in a log where no echo came: numbers as they stand there, or words.
 *
 * @param numbers that stand for no echo, in the log's own unit
 * @param words likewise, in small letters
 */
record NoEchoCodes(List<DoublePredicate> numbers, List<String> words) {
  /** None: every cell has to be a range. */
  static final NoEchoCodes NONE = new NoEchoCodes(List.of(), List.of());

  private static final List<String> USUAL =
      List.of(
          "",
          "nan",
          "inf",
          "+inf",
          "-inf",
          "infinity",
          "+infinity",
          "-infinity",
          "1.#inf",
          "1.#qnan",
          "-1.#ind",
          "ovf",
          "#n/a",
          "-",
          "--",
          "none",
          "null",
          "na",
          "n/a",
          "no echo",
          "noecho",
          "no reading",
          "timeout",
          "time-out",
          "out of range",
          "out-of-range",
          "outofrange",
          "oor");

  /** Copies both. */
  NoEchoCodes {
    numbers = List.copyOf(numbers);
    words = List.copyOf(words);
  }

  /**
   * Reads them from a command line; the usual words are among them unasked.
   *
   * @param codes such as 0,765 or >=400 or "no target"
   */
  static NoEchoCodes of(Optional<String> codes) throws DataFormatException {
    List<DoublePredicate> numbers = new ArrayList<>();
    List<String> words = new ArrayList<>(USUAL);
    for (String code : codes.orElse("").split(",", -1)) {
      String plain = code.strip().toLowerCase(Locale.ROOT);
      Optional<LogNumber> number = LogNumber.find(plain.replaceFirst("^[<>]=", ""), false);
      boolean isPlain = number.isPresent() && number.get().unit().isEmpty();
      if (!isPlain && plain.matches("[<>].*")) {
        throw LogSettings.fault(
            "no-echo", "'" + plain + "' is not a number, expected such as >=400");
      }
      words.add(plain);
      number.ifPresent(is -> numbers.add(test(plain, is.value())));
    }
    return new NoEchoCodes(numbers, words);
  }

  /**
   * Refuses what is neither a number nor stands anywhere in the ranges: it would do nothing.
   *
   * @param codes as for {@link #of}
   * @param logs all tables of the log
   * @param ranges the columns of the ranges, as they were given
   * @throws DataFormatException naming the first such code
   */
  static void requireFound(Optional<String> codes, List<LogTable> logs, String ranges)
      throws DataFormatException {
    for (String code : codes.orElse("").split(",", -1)) {
      String plain = code.strip();
      Optional<LogNumber> number = LogNumber.find(plain.replaceFirst("^[<>]=", ""), false);
      boolean isPlainNumber = number.isPresent() && number.get().unit().isEmpty();
      if (!isPlainNumber
          && !plain.matches("[<>].*")
          && !USUAL.contains(plain.toLowerCase(Locale.ROOT))) {
        requireFound(plain, logs, ranges);
      }
    }
  }

  private static void requireFound(String word, List<LogTable> logs, String ranges)
      throws DataFormatException {
    for (LogTable log : logs) {
      for (int column : LogColumns.list(log, ranges)) {
        for (int row = 0; row < log.size(); row++) {
          if (log.text(row, column).equalsIgnoreCase(word)) {
            return;
          }
        }
      }
    }
    throw LogSettings.fault(
        "no-echo",
        "'"
            + word
            + "' is neither a number as it stands in the log, such as 0,765 or >=400, nor a word"
            + " of the column of ranges");
  }

  private static DoublePredicate test(String code, double value) {
    if (code.startsWith(">")) {
      return number -> number >= value;
    }
    return code.startsWith("<") ? number -> number <= value : number -> number == value;
  }

  boolean isCode(String cell) {
    String small = cell.toLowerCase(Locale.ROOT);
    return words.contains(small) || words.contains(small.replaceFirst("\\s*[!.]+$", ""));
  }

  boolean isCode(double number) {
    return numbers.stream().anyMatch(code -> code.test(number));
  }
}
