package simbad.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.batch.TuningSurvey;
import simbad.figures.plot.Caption;
import simbad.figures.plot.SeriesRole;
import simbad.figures.plot.TuningPlot;

/** {@code simbad batch-plot}: what a batch says of a controller's parameters. */
@Command(
    name = "batch-plot",
    description = {
      "Draw a batch's errors against a parameter of its controller.",
      "Each sensor has a curve; with --curves it has one for each value of a second "
          + "parameter. A curve is the mean over everything else that the batch varied.",
      "A dot marks the setting that a sensor leads to: the one with the least error, "
          + "or with the shortest time if the error is the same everywhere. Its height is "
          + "the error of that setting with the last sensor."
    },
    footer = {
      "",
      "Example: simbad batch-plot my-batch --along crossing_angle_deg --out angles.svg",
      "Example: simbad batch-plot tuning --along crossing_angle_deg --curves curl_rad_per_step"
          + " --out tuning.svg"
    })
final class BatchPlotCommand extends Subcommand {
  @Parameters(paramLabel = "DIR", description = "A batch's folder, with results.csv.")
  private Path folder = Path.of("");

  @Option(
      names = "--along",
      paramLabel = "PARAMETER",
      required = true,
      description = "The controller's parameter on the axis.")
  private String along = "";

  @Option(
      names = "--curves",
      paramLabel = "PARAMETER",
      description =
          "A second parameter; each of its values has a curve. Default: one curve per sensor.")
  private @Nullable String curves;

  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      split = ",",
      description = "Draw only these sensors, named as in results.csv. Default: all.")
  private List<String> chosen = List.of();

  @Option(names = "--out", paramLabel = "FILE", required = true, description = "*.png or *.svg")
  private Path target = Path.of("");

  @Override
  protected void run() throws Exception {
    requirePicture("--out", target);
    if (along.equals(curves)) {
      throw wrongUsage("--curves: " + curves + " is on the axis already (--along)");
    }
    TuningSurvey tuning = read();
    OutputFile.refuseExisting(target);
    OutputFile.draw(plot(tuning).figure(), target);
    tuning.sensors().forEach(sensor -> out().println(said(tuning, sensor)));
    if (!tuning.averaged().isEmpty()) {
      out().println("means over " + String.join(", ", tuning.averaged()) + " too");
    }
    if (tuning.leftOut() > 0) {
      out().println(tuning.leftOut() + " rows without an error are left out");
    }
  }

  /** Reads the rows, and refuses what cannot be told apart in a picture. */
  private TuningSurvey read() throws Exception {
    Path results = folder.resolve("results.csv");
    TuningSurvey all = TuningSurvey.read(results, along, Optional.ofNullable(curves));
    for (String sensor : chosen) {
      if (!all.sensors().contains(sensor)) {
        throw wrongUsage(
            "--sensor: '" + sensor + "' is not one of " + String.join(", ", all.sensors()));
      }
    }
    TuningSurvey tuning = chosen.isEmpty() ? all : all.only(chosen);
    int sensors = tuning.sensors().size();
    if (sensors > TuningLooks.MOST_SENSORS) {
      throw wrongUsage(
          "%s: %d sensors, but only %d have colours of their own: choose with --sensor"
              .formatted(results, sensors, TuningLooks.MOST_SENSORS));
    }
    int most = tuning.sensors().stream().mapToInt(it -> count(tuning, it)).max().orElse(0);
    if (most > TuningPlot.Line.PATTERNS) {
      throw wrongUsage(
          "--curves: %d values of %s, but only %d curves can be told apart: draw it --along"
              .formatted(most, curves, TuningPlot.Line.PATTERNS));
    }
    return tuning;
  }

  /** How many curves a sensor has: one where its error is the same everywhere. */
  private static int count(TuningSurvey tuning, String sensor) {
    return tuning.isIndifferent(sensor) ? 1 : tuning.curves(sensor).size();
  }

  private TuningPlot plot(TuningSurvey tuning) {
    int runs = tuning.settings().stream().mapToInt(TuningSurvey.Setting::runs).sum();
    return new TuningPlot(
        new Caption("Error against the table, by the controller's parameters", runs + " runs"),
        words(along),
        lines(tuning),
        marks(tuning));
  }

  /** A name of a file's column for people: its unit in words, no underscores. */
  private static String words(String parameter) {
    return parameter
        .replaceAll("_deg$", " (degrees)")
        .replaceAll("_rad_per_step$", " (rad per step)")
        .replace('_', ' ');
  }

  private static TuningLooks looks(TuningSurvey tuning) {
    Map<String, Integer> counts = new LinkedHashMap<>();
    tuning.sensors().forEach(sensor -> counts.put(sensor, count(tuning, sensor)));
    return new TuningLooks(counts);
  }

  private List<TuningPlot.Line> lines(TuningSurvey tuning) {
    TuningLooks looks = looks(tuning);
    List<TuningPlot.Line> lines = new ArrayList<>();
    for (String sensor : tuning.sensors()) {
      for (int i = 0; i < count(tuning, sensor); i++) {
        double curve = tuning.curves(sensor).get(i);
        lines.add(
            new TuningPlot.Line(
                name(tuning, sensor, curve),
                looks.role(sensor, i),
                looks.pattern(sensor, i),
                tuning.onCurve(sensor, curve).stream().map(BatchPlotCommand::point).toList()));
      }
    }
    return lines;
  }

  private String name(TuningSurvey tuning, String sensor, double curve) {
    if (curves == null) {
      return sensor;
    }
    boolean one = tuning.isIndifferent(sensor) && tuning.curves(sensor).size() > 1;
    return sensor + ", " + words(curves) + ": " + (one ? "the same for all" : number(curve));
  }

  private static TuningPlot.Point point(TuningSurvey.Setting setting) {
    return new TuningPlot.Point(setting.along(), setting.errorCm());
  }

  /** A dot for each setting, whichever sensors lead to it: one would hide the others. */
  private static List<TuningPlot.Line> marks(TuningSurvey tuning) {
    String judge = tuning.sensors().get(tuning.sensors().size() - 1);
    Map<TuningSurvey.Setting, List<String>> choosers = new LinkedHashMap<>();
    for (String sensor : tuning.sensors()) {
      tuning
          .judgedBy(judge, tuning.chosenWith(sensor))
          .ifPresent(it -> choosers.computeIfAbsent(it, any -> new ArrayList<>()).add(sensor));
    }
    TuningLooks looks = looks(tuning);
    List<TuningPlot.Line> marks = new ArrayList<>();
    choosers.forEach(
        (setting, sensors) ->
            marks.add(
                new TuningPlot.Line(
                    "chosen with " + String.join(", ", sensors) + "; driven with " + judge,
                    sensors.contains(judge) ? SeriesRole.TABLE : looks.role(sensors.get(0), 0),
                    List.of(point(setting)))));
    return marks;
  }

  private String said(TuningSurvey tuning, String sensor) {
    TuningSurvey.Setting best = tuning.chosenWith(sensor);
    String why =
        tuning.isIndifferent(sensor)
            ? "the same error everywhere, the least time"
            : "the least error";
    return String.format(
        Locale.ROOT,
        "%s: %s %s%s (%s: %.2f cm, %.0f s)",
        sensor,
        along,
        number(best.along()),
        curves == null ? "" : ", " + curves + " " + number(best.curve()),
        why,
        best.errorCm(),
        best.timeS());
  }

  /** As short as it can be said. */
  private static String number(double value) {
    return Objects.toString(value).replaceFirst("\\.0$", "");
  }
}
