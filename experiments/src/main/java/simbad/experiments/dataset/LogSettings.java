package simbad.experiments.dataset;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.sonar.format.DataFormatException;

/**
 * What is said about a log: options of a command line by their names without dashes, and what was
 * guessed or asked for since. The values do not change; copies share the memory of which of them
 * were read.
 */
public final class LogSettings {
  private static final Set<String> OF_A_SCENE = Set.of("max-range", "min-range", "cone", "height");

  private final Map<String, List<String>> values;

  /** Options whose values something read. */
  private final Set<String> read;

  /** Takes options with their values. */
  public LogSettings(Map<String, List<String>> values) {
    this(values, new HashSet<>());
  }

  private LogSettings(Map<String, List<String>> values, Set<String> read) {
    this.values = new LinkedHashMap<>(values);
    this.read = read;
  }

  /** Returns the same with one more. */
  LogSettings with(String option, String value) {
    Map<String, List<String>> more = new LinkedHashMap<>(values);
    more.put(option, List.of(value));
    return new LogSettings(more, read);
  }

  /** Returns the same with others where nothing was said; a scene says all of the sonar. */
  public LogSettings orElse(Map<String, List<String>> others) {
    Map<String, List<String>> all = new LinkedHashMap<>(others);
    if (has("scene")) {
      all.keySet().removeAll(OF_A_SCENE);
    }
    all.putAll(values);
    return new LogSettings(all, read);
  }

  /** Returns the same without some options. */
  public LogSettings without(Set<String> options) {
    Map<String, List<String>> less = new LinkedHashMap<>(values);
    less.keySet().removeAll(options);
    return new LogSettings(less, read);
  }

  /** Returns the same under another option's name. */
  LogSettings renamed(String option, String name) {
    Map<String, List<String>> other = new LinkedHashMap<>(values);
    List<String> value = other.remove(option);
    other.put(name, value == null ? List.of() : value);
    return new LogSettings(other, read);
  }

  boolean has(String option) {
    return values.containsKey(option);
  }

  /** Returns an option's value, of several the last. */
  Optional<String> find(String option) {
    List<String> all = all(option);
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(all.size() - 1));
  }

  /** Returns all values of an option, which does not count as reading it. */
  List<String> peek(String option) {
    return values.getOrDefault(option, List.of());
  }

  /** Returns all values of an option that may be given again. */
  List<String> all(String option) {
    read.add(option);
    return peek(option);
  }

  /**
   * Refuses options that nothing read, once all is made: a person would think that they had
   * counted.
   *
   * @throws DataFormatException naming the first one
   */
  public void refuseUnread() throws DataFormatException {
    for (Map.Entry<String, List<String>> option : values.entrySet()) {
      String name = option.getKey();
      if (!read.contains(name) && !name.equals(SKIP_BAD)) {
        throw fault(
            name,
            "'"
                + String.join("' '", option.getValue())
                + "' changes nothing here; expected it only with what it belongs to (see the help)");
      }
    }
  }

  /**
   * Returns an option that is one of some words.
   *
   * @param option its name
   * @param words what it may be, the first one by default
   */
  String word(String option, String... words) throws DataFormatException {
    String word = find(option).orElse(words[0]);
    if (!List.of(words).contains(word)) {
      throw fault(option, "'" + word + "' is not one of " + String.join(", ", words));
    }
    return word;
  }

  /** Finds an option that is a measure with its unit, such as 30cm. */
  Optional<Double> findMeasure(String option, Unit.Kind kind) throws DataFormatException {
    Optional<String> text = find(option);
    return text.isEmpty() ? Optional.empty() : Optional.of(measure(option, text.get(), kind));
  }

  /** Returns a measure in the SI unit, or degrees. */
  static double measure(String option, String text, Unit.Kind kind) throws DataFormatException {
    Optional<LogNumber> number = LogNumber.find(text.strip(), false);
    Optional<Unit> unit = number.flatMap(LogNumber::unit).filter(found -> found.kind() == kind);
    if (number.isEmpty() || unit.isEmpty()) {
      throw fault(
          option,
          "'"
              + text
              + "' is not a number with its unit, such as 30"
              + Unit.words(kind).split(",", 2)[0]
              + " ("
              + Unit.words(kind)
              + ")");
    }
    return unit.get().si(number.get().value());
  }

  /** Finds an option that is a number in a range. */
  Optional<Double> findNumber(String option, double least, double most) throws DataFormatException {
    Optional<String> text = find(option);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    Optional<LogNumber> number = LogNumber.find(text.get().strip(), false);
    if (number.isEmpty()
        || number.get().unit().isPresent()
        || !(number.get().value() >= least && number.get().value() <= most)) {
      throw fault(option, "'" + text.get() + "' is not a number in [" + least + ", " + most + "]");
    }
    return Optional.of(number.get().value());
  }

  /** Finds the file that a word can be. */
  static Optional<Path> findFile(String word) {
    try {
      Path file = Path.of(word);
      return !word.isBlank() && Files.isRegularFile(file) ? Optional.of(file) : Optional.empty();
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  static DataFormatException fault(String option, String problem) {
    return DataFormatException.inArgument("--" + option, problem);
  }

  /** Returns the words of a command line that says the same. */
  public List<String> words() {
    List<String> words = new ArrayList<>();
    values.forEach(
        (option, all) -> {
          for (String value : all) {
            words.add("--" + option);
            if (!option.equals(SKIP_BAD)) {
              words.add(value);
            }
          }
        });
    return words;
  }

  /** The one that has no value. */
  public static final String SKIP_BAD = "skip-bad";
}
