package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.ReadingRow;

/** The rows of a data set, as they are taken from the tables of a log one after the other. */
final class LogRows {
  private final List<ReadingRow> rows = new ArrayList<>();
  private final Map<String, List<String>> further = new LinkedHashMap<>();
  private final List<String> bad = new ArrayList<>();
  private final List<Boolean> follows = new ArrayList<>();
  private Optional<LogTable> lastLog = Optional.empty();
  private int lastRow;
  private int poseless;

  /**
   * How a table is read.
   *
   * @param taken which rows are
   * @param ranges the columns that hold them
   * @param rule how they become readings
   * @param poses where sensor and target were
   * @param clock when
   * @param labels by which rows are told apart, and what else is known of them
   * @param further columns that are kept as they are, by the names that they get
   */
  record Plan(
      List<RowRule> taken,
      List<Range> ranges,
      RangeRule rule,
      PoseRule poses,
      Clock clock,
      Labels labels,
      Map<String, Integer> further) {}

  /**
   * A column of ranges.
   *
   * @param column in which they stand
   * @param sensor whose they are, where no other column says so
   */
  record Range(int column, String sensor) {}

  /**
   * What is known of a row beside its reading.
   *
   * @param runName where no column has it
   * @param run columns that tell the runs apart; none for one run
   * @param sensor column of the sensors' names
   * @param placement column of the placements' words
   * @param temperature of the air, degrees Celsius
   * @param gap from the ping before to this one, seconds
   * @param pause from the echo before to this ping, seconds
   */
  record Labels(
      String runName,
      List<Integer> run,
      OptionalInt sensor,
      OptionalInt placement,
      Optional<LoggedFigure> temperature,
      Optional<LoggedFigure> gap,
      Optional<LoggedFigure> pause) {
    static Labels of(String run) {
      return new Labels(
          run,
          List.of(),
          OptionalInt.empty(),
          OptionalInt.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty());
    }

    Labels withRun(int column) {
      return new Labels(runName, List.of(column), sensor, placement, temperature, gap, pause);
    }

    private String run(LogTable log, int row) throws DataFormatException {
      if (run.isEmpty()) {
        return log.section(row) == 0 ? runName : runName + "-" + (log.section(row) + 1);
      }
      StringBuilder name = new StringBuilder(log.label(row, run.get(0)));
      for (int column : run.subList(1, run.size())) {
        name.append(" ").append(log.label(row, column));
      }
      if (!OneLine.isName(name.toString())) {
        throw log.fault(row, run.get(0), "the run's name is not " + OneLine.NAME);
      }
      return name.toString();
    }

    private Circumstances circumstances(LogTable log, int row) throws DataFormatException {
      Optional<String> where =
          placement.isPresent()
              ? Optional.of(log.label(row, placement.getAsInt()))
              : Optional.empty();
      return new Circumstances(
          true,
          where.filter(word -> !word.isEmpty()),
          of(temperature, log, row),
          Circumstances.NONE.obstacle(),
          of(gap, log, row),
          of(pause, log, row));
    }

    private static OptionalDouble of(Optional<LoggedFigure> figure, LogTable log, int row)
        throws DataFormatException {
      return figure.isEmpty() ? OptionalDouble.empty() : figure.get().of(log, row);
    }
  }

  /**
   * Takes the rows of a table.
   *
   * @param log the table
   * @param plan how
   * @param skipBad whether rows that cannot be read are left out, not refused
   * @throws DataFormatException naming file, line and column of the first fault
   */
  void take(LogTable log, Plan plan, boolean skipBad) throws DataFormatException {
    for (int row = 0; row < log.size(); row++) {
      try {
        take(log, row, plan);
      } catch (DataFormatException e) {
        if (!skipBad) {
          throw e;
        }
        bad.add(String.valueOf(e.getMessage()));
      }
    }
  }

  private void take(LogTable log, int row, Plan plan) throws DataFormatException {
    for (RowRule rule : plan.taken()) {
      if (!rule.takes(log, row)) {
        return;
      }
    }
    Optional<PoseRule.Poses> poses = plan.poses().of(log, row);
    if (poses.isEmpty()) {
      poseless++;
      return;
    }
    Circumstances now = plan.labels().circumstances(log, row).withObstacle(poses.get().obstacle());
    List<ReadingRow> made = new ArrayList<>();
    for (Range range : plan.ranges()) {
      OptionalDouble time = plan.clock().timeS(log, row, rows.size() + made.size());
      made.add(
          new ReadingRow(
              plan.labels().run(log, row),
              plan.labels().sensor().isPresent()
                  ? log.label(row, plan.labels().sensor().getAsInt())
                  : range.sensor(),
              time.orElse(0),
              poses.get().sensor(),
              plan.rule().read(log, row, range.column()),
              time.isPresent() ? now : LoggedPlacements.untimed(now)));
    }
    // Of several readings in one row nobody knows which came first.
    boolean after =
        made.size() == 1 && row == lastRow + 1 && lastLog.filter(log::equals).isPresent();
    made.forEach(reading -> follows.add(after));
    lastLog = Optional.of(log);
    lastRow = row;
    rows.addAll(made);
    for (Map.Entry<String, Integer> column : plan.further().entrySet()) {
      List<String> cells = further.computeIfAbsent(column.getKey(), key -> new ArrayList<>());
      made.forEach(reading -> cells.add(log.text(row, column.getValue())));
    }
  }

  /** The rows in the log's order. */
  List<ReadingRow> rows() {
    return rows;
  }

  /** Of each reading: whether its row of the log comes right after that of the reading before. */
  List<Boolean> follows() {
    return follows;
  }

  /** What was kept beside, one cell for each row. */
  Map<String, List<String>> further() {
    return further;
  }

  /** What was wrong with the rows that were left out for it. */
  List<String> bad() {
    return bad;
  }

  /** How many rows say nothing of where something was. */
  int poseless() {
    return poseless;
  }
}
