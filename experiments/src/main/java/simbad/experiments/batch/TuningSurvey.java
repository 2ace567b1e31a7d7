package simbad.experiments.batch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.sonar.check.Checks;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * What a batch says of one or two parameters of a controller: per sensor and setting, the mean
 * error and the mean time of a round over everything else that the batch varied. Immutable.
 *
 * @param settings in the order of the rows in which they first stand
 * @param leftOut rows that failed or have no error, which no mean contains
 * @param averaged the controller's other parameters that the batch varied, which the means are over
 */
public record TuningSurvey(List<Setting> settings, int leftOut, List<String> averaged) {
  /** Errors that differ by less than this share leave only the time to choose by. */
  private static final double SAME = 0.01;

  /**
   * One sensor with one setting of both parameters.
   *
   * @param sensor as results.csv names it
   * @param along value of the parameter that is drawn along the axis
   * @param curve value of the parameter that has a curve for each value; 0 where there is none
   * @param errorCm mean of mean_abs_cm over the runs
   * @param timeS mean of the simulated time of a round
   * @param runs how many runs the means are of; at least 1
   */
  public record Setting(
      String sensor, double along, double curve, double errorCm, double timeS, int runs) {
    /** Checks that all are numbers. */
    public Setting {
      Checks.number("along", along);
      Checks.number("curve", curve);
      Checks.number("errorCm", errorCm);
      Checks.number("timeS", timeS);
    }

    private boolean isSameAs(Setting other) {
      return sensor.equals(other.sensor) && along == other.along && curve == other.curve;
    }

    private Setting with(Setting run) {
      int all = runs + 1;
      return new Setting(
          sensor,
          along,
          curve,
          errorCm + (run.errorCm - errorCm) / all,
          timeS + (run.timeS - timeS) / all,
          all);
    }
  }

  /** Copies the lists. */
  public TuningSurvey {
    settings = List.copyOf(settings);
    averaged = List.copyOf(averaged);
  }

  /**
   * Reads a batch's rows.
   *
   * @param results a results.csv
   * @param along name of a controller's parameter
   * @param curve name of another one; without it each sensor has one curve
   * @throws DataFormatException for a file without these columns, or without a single usable row
   */
  public static TuningSurvey read(Path results, String along, Optional<String> curve)
      throws IOException, DataFormatException {
    CsvTable table = CsvTable.parse(results, TextFile.read(results));
    List<String> parameters = new ArrayList<>(List.of(ResultColumns.PARAMETER + along));
    curve.ifPresent(name -> parameters.add(ResultColumns.PARAMETER + name));
    table.requireColumns("sensor", ResultColumns.STATUS, "mean_abs_cm", "simulated_s");
    requireParameters(results, table, parameters);
    List<Setting> settings = new ArrayList<>();
    int leftOut = 0;
    for (int row = 0; row < table.size(); row++) {
      if (isUsable(table, row, parameters)) {
        add(settings, setting(table, row, parameters));
      } else {
        leftOut++;
      }
    }
    if (settings.isEmpty()) {
      throw DataFormatException.inFile(
          results, "no row has an error and a value of " + String.join(" and ", parameters));
    }
    return new TuningSurvey(settings, leftOut, averaged(table, parameters));
  }

  private static void requireParameters(Path results, CsvTable table, List<String> parameters)
      throws DataFormatException {
    for (String name : parameters) {
      if (!table.columns().contains(name)) {
        int prefix = ResultColumns.PARAMETER.length();
        String known =
            table.columns().stream()
                .filter(column -> column.startsWith(ResultColumns.PARAMETER))
                .map(column -> column.substring(prefix))
                .collect(Collectors.joining(", "));
        throw DataFormatException.inFile(
            results, "no parameter '" + name.substring(prefix) + "', expected one of " + known);
      }
    }
  }

  private static boolean isUsable(CsvTable table, int row, List<String> parameters) {
    return table.text(row, ResultColumns.STATUS).equals(ResultColumns.DONE)
        && !table.text(row, "mean_abs_cm").isEmpty()
        && parameters.stream().noneMatch(name -> table.text(row, name).isEmpty());
  }

  private static Setting setting(CsvTable table, int row, List<String> parameters)
      throws DataFormatException {
    return new Setting(
        table.label(row, "sensor"),
        table.number(row, parameters.get(0), Double::isFinite, "a number"),
        parameters.size() > 1
            ? table.number(row, parameters.get(1), Double::isFinite, "a number")
            : 0,
        table.number(row, "mean_abs_cm", cm -> cm >= 0, "at least 0"),
        table.number(row, "simulated_s", s -> s >= 0, "at least 0"),
        1);
  }

  private static List<String> averaged(CsvTable table, List<String> parameters) {
    return table.columns().stream()
        .filter(name -> name.startsWith(ResultColumns.PARAMETER) && !parameters.contains(name))
        .filter(
            name ->
                IntStream.range(0, table.size())
                        .mapToObj(row -> table.text(row, name))
                        .distinct()
                        .count()
                    > 1)
        .map(name -> name.substring(ResultColumns.PARAMETER.length()))
        .toList();
  }

  private static void add(List<Setting> settings, Setting run) {
    for (int i = 0; i < settings.size(); i++) {
      if (settings.get(i).isSameAs(run)) {
        settings.set(i, settings.get(i).with(run));
        return;
      }
    }
    settings.add(run);
  }

  /** Returns the sensors, in the order of the rows. */
  public List<String> sensors() {
    return settings.stream().map(Setting::sensor).distinct().toList();
  }

  /**
   * Returns the same of some of the sensors.
   *
   * @param sensors names, of which at least one must be among {@link #sensors()}
   */
  public TuningSurvey only(List<String> sensors) {
    List<Setting> kept = settings.stream().filter(it -> sensors.contains(it.sensor())).toList();
    return new TuningSurvey(kept, leftOut, averaged);
  }

  /** Returns the values for which a sensor has a curve, ascending. */
  public List<Double> curves(String sensor) {
    return of(sensor).stream().map(Setting::curve).distinct().sorted().toList();
  }

  /** Returns a sensor's settings on one curve, along the axis. */
  public List<Setting> onCurve(String sensor, double curve) {
    return of(sensor).stream()
        .filter(setting -> setting.curve() == curve)
        .sorted(Comparator.comparingDouble(Setting::along))
        .toList();
  }

  private List<Setting> of(String sensor) {
    return settings.stream().filter(setting -> setting.sensor().equals(sensor)).toList();
  }

  /** Tells whether all of a sensor's settings have the same error, to 1 %. */
  public boolean isIndifferent(String sensor) {
    double least = of(sensor).stream().mapToDouble(Setting::errorCm).min().orElse(0);
    double most = of(sensor).stream().mapToDouble(Setting::errorCm).max().orElse(0);
    return most <= least * (1 + SAME);
  }

  /**
   * Returns the setting to which a sensor leads: that of the least error; where the error is the
   * same everywhere, that of the least time.
   */
  public Setting chosenWith(String sensor) {
    ToDoubleFunction<Setting> cost = isIndifferent(sensor) ? Setting::timeS : Setting::errorCm;
    return of(sensor).stream().min(Comparator.comparingDouble(cost)).orElseThrow();
  }

  /** Returns what a sensor makes of another one's choice, if its rows have that setting. */
  public Optional<Setting> judgedBy(String sensor, Setting choice) {
    return of(sensor).stream()
        .filter(it -> it.along() == choice.along() && it.curve() == choice.curve())
        .findFirst();
  }
}
