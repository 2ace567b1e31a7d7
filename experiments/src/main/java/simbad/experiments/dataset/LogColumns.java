package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.sonar.format.DataFormatException;

/** Columns as a person names them: by name, whatever the case, or by number from 1. */
final class LogColumns {
  private LogColumns() {}

  /**
   * Finds a column.
   *
   * @param log the table
   * @param word a name of the header, or a number from 1
   * @return empty if there is none
   * @throws DataFormatException if several have that name
   */
  static OptionalInt find(LogTable log, String word) throws DataFormatException {
    List<String> names = log.names();
    if (names.indexOf(word) >= 0 && names.indexOf(word) == names.lastIndexOf(word)) {
      return OptionalInt.of(names.indexOf(word));
    }
    int[] alike =
        IntStream.range(0, names.size())
            .filter(i -> names.get(i).equalsIgnoreCase(word.strip()) && !word.isBlank())
            .toArray();
    if (alike.length > 1) {
      throw log.twice(word);
    }
    if (alike.length == 1) {
      return OptionalInt.of(alike[0]);
    }
    if (word.matches("\\d{1,4}") && Integer.parseInt(word) >= 1) {
      int number = Integer.parseInt(word);
      return number <= names.size() ? OptionalInt.of(number - 1) : OptionalInt.empty();
    }
    return OptionalInt.empty();
  }

  /** Returns a column that has to be there. */
  static int require(LogTable log, String word) throws DataFormatException {
    OptionalInt found = find(log, word);
    if (found.isEmpty()) {
      throw log.missing(word);
    }
    return found.getAsInt();
  }

  /**
   * Returns some columns in their order, none twice.
   *
   * @param log the table
   * @param words columns and stretches of columns, m1-m10, with commas between
   */
  static List<Integer> list(LogTable log, String words) throws DataFormatException {
    if (find(log, words).isPresent()) {
      return List.of(require(log, words));
    }
    Set<Integer> columns = new LinkedHashSet<>();
    for (String word : words.split(",", -1)) {
      OptionalInt one = find(log, word.strip());
      if (one.isPresent()) {
        columns.add(one.getAsInt());
      } else {
        columns.addAll(stretch(log, word.strip()));
      }
    }
    return new ArrayList<>(columns);
  }

  /** Finds what {@link #list} returns; none where the words are no columns. */
  static List<Integer> findAll(LogTable log, String words) {
    try {
      return list(log, words);
    } catch (DataFormatException e) {
      return List.of();
    }
  }

  private static List<Integer> stretch(LogTable log, String word) throws DataFormatException {
    for (int dash = word.indexOf('-'); dash > 0; dash = word.indexOf('-', dash + 1)) {
      OptionalInt from = find(log, word.substring(0, dash).strip());
      OptionalInt to = find(log, word.substring(dash + 1).strip());
      if (from.isPresent() && to.isPresent() && from.getAsInt() <= to.getAsInt()) {
        return IntStream.rangeClosed(from.getAsInt(), to.getAsInt()).boxed().toList();
      }
    }
    throw log.missing(word);
  }
}
