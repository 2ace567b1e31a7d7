package simbad.experiments.dataset;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.sonar.format.DataFormatException;

/**
 * Completes what is said of a log: by the names of its columns where they say it, else by asking.
 * What is guessed is an assumption.
 */
final class LogGuess {
  private static final Pattern RANGE =
      Pattern.compile("(?i).*(read|range|measur|ultra|sonar|echo|sensor|misur|lettura|mess).*");
  private static final Pattern TRUE =
      Pattern.compile("(?i).*(true|truth|actual|real|tape|ruler|nominal|soll|vera|expected).*");

  /** The range or the true distance, as other columns leave it. */
  private static final Pattern DISTANCE =
      Pattern.compile("(?i).*(dist|abstand|entfernung|distan).*");

  /** What stands beside readings as well, and may grow as they do. */
  private static final Pattern OTHER =
      Pattern.compile(
          "(?i).*(time|zeit|temp|volt|vcc|batt|angle|winkel|head|pan|servo|index|count).*|id|nr|no|n|i|t|s|sec|ms|us|deg");

  /** Of all rows, so many are like the two before in what was taken for the ranges. */
  private static final double STAYS = 0.3;

  /** Two of three steps of what scatters turn; one in four is out of the question for a cart. */
  private static final double TURNS = 0.25;

  private static final int SAMPLE = 100;

  /** Of pairs of rows that differ, so many more in the same order than in the other. */
  private static final double GOES_WITH = 0.7;

  private static final String[] POSES = {
    "distance", "x", "z", "y", "bearing", "target-x", "target-z", "target-y"
  };

  /** What else may stand in a column that is not the ranges. */
  private static final List<String> BESIDE =
      List.of(
          "heading",
          "pan",
          "target-turn",
          "time",
          "run",
          "sensor",
          "placement",
          "temperature",
          "gap-ms",
          "pause-ms");

  private final LogTable log;
  private final Questions questions;
  private final Assumptions assumptions;
  private LogSettings answered;
  private boolean isRangeSaid;

  LogGuess(LogTable log, Questions questions, Assumptions assumptions) {
    this.log = log;
    this.questions = questions;
    this.assumptions = assumptions;
    answered = new LogSettings(Map.of());
  }

  /**
   * Returns what was said with what was answered: guesses will be the same another time, and
   * assumptions again.
   */
  LogSettings answered() {
    return answered;
  }

  /** Returns the settings with all that is needed. */
  LogSettings complete(LogSettings said) throws DataFormatException {
    LogSettings settings = said;
    answered = said;
    isRangeSaid = settings.has("range");
    if (!isRangeSaid) {
      settings = settings.with("range", range(elsewhere(said)));
    }
    List<Integer> ranges = LogColumns.list(log, settings.find("range").orElseThrow());
    if (!settings.has("range-unit")) {
      settings = settings.with("range-unit", unit(ranges.get(0)));
    }
    if (Stream.of(POSES).noneMatch(settings::has)) {
      settings = settings.with("distance", distance(ranges));
      if (!isRangeSaid && ranges.size() == 1) {
        refuseExchanged(ranges.get(0), LogColumns.findAll(log, settings.find("distance").get()));
      }
    }
    return settings.has("target") || settings.has("scene")
        ? settings
        : settings.with("target", target(settings));
  }

  /** The columns that something said is to be found in. */
  private Set<Integer> elsewhere(LogSettings said) {
    Set<Integer> columns = new HashSet<>();
    Stream.concat(Stream.of(POSES), BESIDE.stream())
        .flatMap(option -> said.peek(option).stream())
        .forEach(words -> columns.addAll(LogColumns.findAll(log, words)));
    return columns;
  }

  private String range(Set<Integer> elsewhere) throws DataFormatException {
    Test free = column -> !elsewhere.contains(column) && hasNumbers(column);
    List<Integer> numbers = columns(free);
    if (numbers.isEmpty()) {
      throw log.fault(
          "no column"
              + (elsewhere.isEmpty() ? "" : " but those of other options")
              + " holds numbers, expected ranges; found "
              + log.shown());
    }
    Optional<Integer> column =
        only(at -> isNamed(RANGE, at) && !isNamed(TRUE, at) && free.holds(at))
            .or(() -> besideTheTrue(numbers))
            .or(() -> onlyNumbers(free))
            .or(() -> only(at -> isNamed(DISTANCE, at) && !isNamed(TRUE, at) && free.holds(at)))
            .or(() -> only(at -> isNamed(RANGE, at) && !isNamed(TRUE, at)));
    if (column.isEmpty()) {
      return ask("range", "which column holds the sensor's readings", log.shown());
    }
    assumptions.add("The ranges are in column " + shown(column.get()) + " (--range).");
    return word(column.get());
  }

  /** The one column of numbers, where no other calls itself a range. */
  private Optional<Integer> onlyNumbers(Test free) {
    return columns(at -> isNamed(RANGE, at)).isEmpty()
        ? only(at -> free.holds(at) && !isNamed(TRUE, at))
        : Optional.empty();
  }

  /** Of two columns the one that is not the true distance; without names the second one. */
  private Optional<Integer> besideTheTrue(List<Integer> numbers) {
    if (log.names().size() != 2 || numbers.size() != 2) {
      return Optional.empty();
    }
    boolean first = isNamed(TRUE, 0);
    boolean second = isNamed(TRUE, 1);
    return first == second && !log.isUnnamed()
        ? Optional.empty()
        : Optional.of(second && !first ? 0 : 1);
  }

  private String unit(int column) throws DataFormatException {
    Optional<Unit> own = log.findNumber(0, column).flatMap(LogNumber::unit);
    Optional<Unit> found = own.isPresent() ? own : Unit.inName(log.names().get(column));
    Optional<Unit> unit = found.filter(is -> is.kind() != Unit.Kind.ANGLE);
    return unit.isPresent()
        ? unit.get().word()
        : ask(
            "range-unit",
            "cm, mm, m, in, us or another",
            "column "
                + examples(column)
                + (isRangeSaid ? "" : " (taken for the ranges; --range takes another)"));
  }

  private String distance(List<Integer> ranges) throws DataFormatException {
    Optional<Integer> named =
        only(column -> isNamed(TRUE, column) && !ranges.contains(column))
            .or(
                () ->
                    only(
                        column ->
                            isNamed(DISTANCE, column)
                                && !ranges.contains(column)
                                && hasNumbers(column)));
    boolean two =
        log.names().size() == 2
            && ranges.size() == 1
            && hasNumbers(1 - ranges.get(0))
            && mayBeDistance(1 - ranges.get(0), ranges.get(0));
    if (named.isPresent() || two) {
      int column = named.orElse(two ? 1 - ranges.get(0) : 0);
      assumptions.add("The true distances are in column " + shown(column) + " (--distance).");
      return word(column);
    }
    return ask(
        "distance",
        "which column holds the true distance (or --x and --z for places, or a fixed one: 30cm)",
        log.shown());
  }

  /**
   * Whether the one column beside the ranges may be what a tape says, and not a time or an angle.
   */
  private boolean mayBeDistance(int column, int range) {
    Optional<Unit> unit = Unit.inName(log.names().get(column));
    return log.isUnnamed()
        || unit.map(is -> is.kind() == Unit.Kind.LENGTH)
            .orElseGet(() -> !isNamed(OTHER, column) && goesWith(column, range));
  }

  /** Kendall's tau of two columns. */
  private boolean goesWith(int one, int other) {
    int pairs = 0;
    int balance = 0;
    int step = 1 + log.size() / SAMPLE;
    for (int i = 0; i < log.size(); i += step) {
      for (int j = 0; j < i; j += step) {
        double order = order(one, i, j) * order(other, i, j);
        pairs += order == 0 ? 0 : 1;
        balance += (int) order;
      }
    }
    return balance > GOES_WITH * pairs;
  }

  /** The sign of what a column grows by between two rows; 0 also where one has no number. */
  private double order(int column, int row, int before) {
    Optional<LogNumber> now = log.findNumber(row, column);
    Optional<LogNumber> then = log.findNumber(before, column);
    return now.isPresent() && then.isPresent()
        ? Math.signum(now.get().value() - then.get().value())
        : 0;
  }

  /**
   * Refuses a guess where what was taken for the ranges stays the same again and again, while what
   * was taken for the true distance goes up and down beside it: as readings do beside a tape.
   */
  private void refuseExchanged(int range, List<Integer> distances) throws DataFormatException {
    if (distances.size() != 1) {
      return;
    }
    int distance = distances.get(0);
    int stays = 0;
    int turns = 0;
    for (int i = 2; i < log.size(); i++) {
      boolean same = isSame(range, i, i - 1) && isSame(range, i - 1, i - 2);
      stays += same ? 1 : 0;
      turns += same && order(distance, i, i - 1) * order(distance, i - 1, i - 2) < 0 ? 1 : 0;
    }
    if (stays > STAYS * log.size() && turns > TURNS * stays) {
      throw log.fault(
          "column "
              + shown(range)
              + " stays the same while column "
              + shown(distance)
              + " goes up and down beside it; expected readings in the first and true distances in"
              + " the second: are they exchanged? --range and --distance say which is which");
    }
  }

  private boolean isSame(int column, int row, int before) {
    Optional<LogNumber> now = log.findNumber(row, column);
    return now.isPresent() && now.equals(log.findNumber(before, column));
  }

  private String target(LogSettings settings) throws DataFormatException {
    boolean ladder =
        settings.has("distance")
            && Stream.of("x", "bearing", "pan", "target-turn", "heading").noneMatch(settings::has);
    if (ladder) {
      assumptions.add("The target is a board of 1.2 m that faces the sensor (--target).");
      return "board:1.2m";
    }
    return ask(
        "target", "what the sensor looked at, such as board:1.2m, round:30mm, angle", "none");
  }

  private String ask(String option, String question, String seen) throws DataFormatException {
    String answer = questions.ask(option, question, seen);
    answered = answered.with(option, answer);
    return answer;
  }

  private interface Test {
    boolean holds(int column);
  }

  private List<Integer> columns(Test test) {
    return IntStream.range(0, log.names().size()).filter(test::holds).boxed().toList();
  }

  private Optional<Integer> only(Test test) {
    List<Integer> found = columns(test);
    return found.size() == 1 ? Optional.of(found.get(0)) : Optional.empty();
  }

  private boolean isNamed(Pattern pattern, int column) {
    return pattern.matcher(log.names().get(column)).matches();
  }

  private boolean hasNumbers(int column) {
    return IntStream.range(0, Math.min(SAMPLE, log.size()))
        .anyMatch(row -> log.findNumber(row, column).isPresent());
  }

  private String shown(int column) {
    return (column + 1) + ", '" + log.names().get(column) + "'";
  }

  private String examples(int column) {
    return shown(column) + ": " + log.text(0, column);
  }

  /** A name where it tells the column from the others, else its number. */
  private String word(int column) throws DataFormatException {
    String name = log.names().get(column);
    boolean alone = log.names().stream().filter(name::equalsIgnoreCase).count() == 1;
    OptionalInt found = alone ? LogColumns.find(log, name) : OptionalInt.empty();
    return found.isPresent() ? name : Integer.toString(column + 1);
  }
}
