package simbad.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.fidelity.FidelityVerdict;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.figures.report.RunReport;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;

/** {@code simbad fidelity}: the thesis's test of a sensor model. */
@Command(
    name = "fidelity",
    description = {
      "Test whether a sensor model is faithful to threshold tables.",
      "Prints the errors of its detection map and of a trace round each obstacle, and "
          + "a verdict.",
      "A model is faithful if it agrees with the table at 98 %% of the poses, its "
          + "mean radial error is at most 3 cm, its mean lateral error at most 1 cm, the "
          + "trace keeps 95 %% of the edge, and every bearing is reached. Exit status 0 "
          + "whatever the verdict."
    },
    footer = {
      "",
      "Example: simbad fidelity angle --sensor overlap",
      "Example: simbad fidelity my-table.csv --sensor diagnosed:diagnoses/bench-3 --out fidelity"
    })
final class FidelityCommand extends Subcommand {
  @Parameters(
      paramLabel = "OBSTACLE",
      arity = "0..*",
      description = ObstacleArgument.MEANING + " Default: square, round, angle.")
  private List<String> obstacles = List.of("square", "round", "angle");

  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      completionCandidates = SensorWords.class,
      description = "As in simbad run. Default: ${DEFAULT-VALUE}.")
  private String sensor = "shadow";

  @Mixin private DriveOptions drive = new DriveOptions();

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "Write traces, maps, errors and a page, as simbad run does. The page begins "
              + "with the verdict.")
  private @Nullable Path out;

  @Override
  protected void run() throws Exception {
    RunSettings settings = settings();
    List<RunResult> results;
    try (Progress progress = Progress.of("driving", settings.obstacles().size())) {
      results = Experiment.run(settings, result -> progress.step());
    }
    if (out != null) {
      try (StagedDirectory staged = StagedDirectory.beside(out)) {
        RunOrigin origin = new RunOrigin(BuildVersion.text(), settings);
        RunReport.write(staged.path(), origin, results, FidelityLimits.STANDARD);
        staged.publish();
      }
    }
    for (RunResult result : results) {
      String verdict = FidelityVerdict.of(result, FidelityLimits.STANDARD).sentence();
      out().println(result.type().name() + ", " + result.sensor().word() + ": " + verdict);
      out().println("  " + FidelityVerdict.figures(result));
    }
    if (out != null) {
      out().println("written to " + out + " (open " + out.resolve("report.html") + ")");
    }
  }

  private RunSettings settings() throws DataFormatException {
    double speedMPerS = drive.speedMPerS(this);
    SensorKind kind =
        SensorKind.read(sensor)
            .orElseThrow(() -> wrongUsage("--sensor: " + SensorArgument.unknown(sensor)));
    List<ObstacleType> types = ObstacleArgument.distinct(obstacles);
    return new RunSettings(types, List.of(kind), drive.sonar(), speedMPerS, Optional.empty(), 1);
  }
}
