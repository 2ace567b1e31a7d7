package simbad.experiments.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.batch.Tuning;
import simbad.experiments.plot.Caption;
import simbad.experiments.plot.SeriesRole;
import simbad.experiments.plot.TuningPlot;

/** {@code simbad batch-plot}: what a batch says of a controller's parameters. */
@Command(
    name = "batch-plot",
    description = {
      "Draw a batch's errors over a parameter of its controller, a curve for each sensor and value"
          + " of a second parameter, each the mean over all else that the batch varied.",
      "Dots are the settings to which each sensor leads, as the last sensor judges them: the least"
          + " error, or, where the error is the same everywhere, the shortest time."
    },
    footer = {
      "",
      "Example: simbad batch-plot tuning --along crossing_angle_deg --curves curl_rad_per_step"
          + " --out tuning.svg"
    })
final class BatchPlotCommand extends Subcommand {
  /** That of the original sensor is its own; others take these in turn. */
  private static final List<SeriesRole> ROLES =
      List.of(
          SeriesRole.SHADOW,
          SeriesRole.OVERLAP,
          SeriesRole.NOISY,
          SeriesRole.RAY,
          SeriesRole.OTHER);

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
      required = true,
      description = "Another one; each of its values has a curve.")
  private String curves = "";

  @Option(names = "--out", paramLabel = "FILE", required = true, description = "*.png or *.svg")
  private Path target = Path.of("");

  @Override
  protected void run() throws Exception {
    requirePicture("--out", target);
    Tuning tuning = Tuning.read(folder.resolve("results.csv"), along, curves);
    OutputFile.refuseExisting(target);
    OutputFile.draw(plot(tuning).figure(), target);
    tuning.sensors().forEach(sensor -> out().println(said(tuning, sensor)));
    if (tuning.leftOut() > 0) {
      out().println(tuning.leftOut() + " rows without an error are left out");
    }
  }

  private TuningPlot plot(Tuning tuning) {
    int runs = tuning.settings().stream().mapToInt(Tuning.Setting::runs).sum();
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

  private List<TuningPlot.Line> lines(Tuning tuning) {
    List<TuningPlot.Line> lines = new ArrayList<>();
    int next = 0;
    for (String sensor : tuning.sensors()) {
      boolean one = tuning.isIndifferent(sensor);
      for (double curve : one ? tuning.curves().subList(0, 1) : tuning.curves()) {
        SeriesRole role = one ? SeriesRole.ORIGINAL : ROLES.get(next++ % ROLES.size());
        String of = one ? "the same for all" : number(curve);
        lines.add(
            new TuningPlot.Line(
                sensor + ", " + words(curves) + ": " + of,
                role,
                tuning.onCurve(sensor, curve).stream().map(BatchPlotCommand::point).toList()));
      }
    }
    return lines;
  }

  private static TuningPlot.Point point(Tuning.Setting setting) {
    return new TuningPlot.Point(setting.along(), setting.errorCm());
  }

  private static List<TuningPlot.Line> marks(Tuning tuning) {
    List<String> sensors = tuning.sensors();
    String judge = sensors.get(sensors.size() - 1);
    return sensors.stream()
        .flatMap(
            sensor ->
                tuning.judgedBy(judge, tuning.chosenWith(sensor)).stream()
                    .map(
                        setting ->
                            new TuningPlot.Line(
                                "chosen with " + sensor + ", driven with " + judge,
                                sensor.equals(judge) ? SeriesRole.TABLE : SeriesRole.ORIGINAL,
                                List.of(point(setting)))))
        .toList();
  }

  private String said(Tuning tuning, String sensor) {
    Tuning.Setting best = tuning.chosenWith(sensor);
    String why =
        tuning.isIndifferent(sensor)
            ? "the same error everywhere, the least time"
            : "the least error";
    return String.format(
        Locale.ROOT,
        "%s: %s %s, %s %s (%s: %.2f cm, %.0f s)",
        sensor,
        along,
        number(best.along()),
        curves,
        number(best.curve()),
        why,
        best.errorCm(),
        best.timeS());
  }

  /** As short as it can be said. */
  private static String number(double value) {
    return Objects.toString(value).replaceFirst("\\.0$", "");
  }
}
