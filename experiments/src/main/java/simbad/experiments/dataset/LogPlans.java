package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.SonarSpec;

/** How the tables of a log become rows, as the options say it. */
final class LogPlans {
  private static final Set<String> TAKEN =
      Set.of(
          "run",
          "sensor",
          "t_s",
          "x_m",
          "z_m",
          "heading_deg",
          "range_m",
          "placement",
          "temperature_c",
          "obstacle_x_m",
          "obstacle_z_m",
          "obstacle_turn_deg",
          "gap_ms",
          "pause_ms");

  private final LogSettings settings;
  private final SonarSpec sonar;
  private final Target target;
  private final Map<String, Placement> mounts;
  private final Assumptions assumptions;

  LogPlans(
      LogSettings settings,
      SonarSpec sonar,
      Target target,
      Map<String, Placement> mounts,
      Assumptions assumptions) {
    this.settings = settings;
    this.sonar = sonar;
    this.target = target;
    this.mounts = mounts;
    this.assumptions = assumptions;
  }

  /** Returns the plans for a table, one after the other. */
  List<LogRows.Plan> of(LogTable log) throws DataFormatException {
    LogFigures figures = new LogFigures(log, settings, assumptions);
    LogPoses poses = new LogPoses(log, settings, assumptions, target);
    List<LogRows.Range> ranges = ranges(log);
    RangeRule rule =
        new RangeRule(
            figures.unit("range-unit", Unit.Kind.LENGTH, Unit.Kind.TIME),
            sonar.assumedSoundSpeedMPerS(),
            NoEchoCodes.of(settings.find("no-echo")));
    List<RowRule> taken = RowRule.of(log, settings);
    Clock clock = clock(log, figures, ranges.size());
    LogRows.Labels labels = labels(log, figures);
    Map<String, Integer> further = further(log, ranges);
    // With the distance in the columns' names each column has its own.
    boolean apart = settings.find("distance").filter(LogPoses.HEADER::equals).isPresent();
    List<LogRows.Plan> plans = new ArrayList<>();
    for (LogRows.Range range : apart ? ranges : ranges.subList(0, 1)) {
      PoseRule rulePoses = poses.rule(range.column(), !mounts.isEmpty());
      List<LogRows.Range> together = apart ? List.of(range) : ranges;
      plans.add(new LogRows.Plan(taken, together, rule, rulePoses, clock, labels, further));
    }
    return plans;
  }

  private List<LogRows.Range> ranges(LogTable log) throws DataFormatException {
    List<Integer> columns = LogColumns.list(log, settings.find("range").orElse(""));
    boolean mounted =
        columns.stream().anyMatch(column -> mounts.containsKey(sensor(log.names().get(column))));
    boolean sensors =
        settings
            .word("wide", mounted ? "sensors" : "repeats", "sensors", "repeats")
            .equals("sensors");
    if (columns.size() > 1 && !settings.has("wide")) {
      assumptions.add(
          "The columns of ranges are "
              + (sensors ? "sensors of their own" : "repeats of one sensor")
              + " (--wide).");
    }
    String alone = mounts.size() == 1 ? mounts.keySet().iterator().next() : sonar.name();
    List<LogRows.Range> ranges = new ArrayList<>();
    for (int column : columns) {
      String name = sensor(log.names().get(column));
      if (sensors && !mounts.isEmpty() && !mounts.containsKey(name)) {
        throw LogSettings.fault(
            "mount",
            "column '"
                + name
                + "' is a sensor without one, expected "
                + name
                + "=X,Z,TURN as well");
      }
      ranges.add(
          new LogRows.Range(column, sensors ? OneLine.of(name, OneLine.LONGEST_NAME - 3) : alone));
    }
    return ranges;
  }

  /** A column is the sensor of its name, or of its name without the unit: front of front_cm. */
  private String sensor(String column) {
    if (mounts.containsKey(column) || Unit.inName(column).isEmpty()) {
      return column;
    }
    String stem = column.strip().replaceFirst("[^\\p{L}\\d]+\\p{L}+[^\\p{L}\\d]*$", "");
    return mounts.containsKey(stem) ? stem : column;
  }

  private Clock clock(LogTable log, LogFigures figures, int columns) throws DataFormatException {
    OptionalInt time = figures.findColumn("time");
    Optional<Double> period = LogSonar.periodS(settings);
    if (time.isEmpty()) {
      return period.isEmpty()
          ? Clock.NONE
          : columns > 1 ? Clock.ofTaken(period.get()) : Clock.ofRows(period.get());
    }
    return Clock.of(log, time.getAsInt(), timeUnit(log, figures, time.getAsInt()));
  }

  private Unit timeUnit(LogTable log, LogFigures figures, int column) throws DataFormatException {
    if (settings.has("time-unit")) {
      return figures.unit("time-unit", Unit.Kind.TIME);
    }
    Optional<Unit> named =
        Unit.inName(log.names().get(column)).filter(unit -> unit.kind() == Unit.Kind.TIME);
    if (named.isPresent() || log.findNumber(0, column).isEmpty()) {
      return named.orElse(Unit.S);
    }
    throw LogSettings.fault(
        "time-unit",
        "is missing: "
            + Unit.words(Unit.Kind.TIME)
            + "; saw column "
            + log.names().get(column)
            + ": "
            + log.text(0, column));
  }

  private LogRows.Labels labels(LogTable log, LogFigures figures) throws DataFormatException {
    String stem =
        String.valueOf(log.file().getFileName()).replaceFirst("(\\.[A-Za-z]{1,4}){1,2}$", "");
    return new LogRows.Labels(
        OneLine.of(stem, OneLine.LONGEST_NAME - 20),
        settings.has("run") ? LogColumns.list(log, settings.find("run").orElse("")) : List.of(),
        figures.findColumn("sensor"),
        figures.findColumn("placement"),
        figures.temperature("temperature"),
        figures.duration("gap-ms"),
        figures.duration("pause-ms"));
  }

  /** All columns that are not used, by names that mean nothing to a data set. */
  private Map<String, Integer> further(LogTable log, List<LogRows.Range> ranges)
      throws DataFormatException {
    Set<Integer> used = new HashSet<>();
    ranges.forEach(range -> used.add(range.column()));
    for (String option : OPTIONS) {
      for (String word : settings.all(option)) {
        used.addAll(LogColumns.findAll(log, word));
      }
    }
    Map<String, Integer> further = new LinkedHashMap<>();
    for (int column = 0; column < log.names().size(); column++) {
      if (!used.contains(column)) {
        further.putIfAbsent(free(log, column, further.keySet()), column);
      }
    }
    return further;
  }

  /** Those of which a column's content stands in the data set already. */
  private static final List<String> OPTIONS =
      List.of("time", "run", "sensor", "placement", "temperature", "gap-ms", "pause-ms");

  private static String free(LogTable log, int column, Set<String> others) {
    String name = OneLine.of(log.names().get(column), OneLine.LONGEST_NAME - 20);
    boolean free = !name.isEmpty() && !TAKEN.contains(name) && !others.contains(name);
    // A line that begins with # would be a comment.
    return free && !name.startsWith("#") ? name : "log_" + (column + 1) + "_" + name;
  }

  /** Where the sensors are on a robot. */
  static Map<String, Placement> mounts(LogSettings settings) throws DataFormatException {
    Map<String, Placement> mounts = new LinkedHashMap<>();
    for (String mount : settings.all("mount")) {
      int equals = mount.indexOf('=');
      if (equals < 1 || !OneLine.isName(mount.substring(0, equals))) {
        throw LogSettings.fault(
            "mount", "'" + mount + "' is not SENSOR=X,Z,TURN, such as left=5cm,-8cm,90deg");
      }
      mounts.put(mount.substring(0, equals), Target.place("mount", mount.substring(equals + 1)));
    }
    return mounts;
  }
}
