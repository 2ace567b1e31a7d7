package simbad.experiments.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.fidelity.FidelityVerdict;
import simbad.experiments.report.RunFiles;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad fidelity}: the thesis's test of a sensor model. */
@Command(
    name = "fidelity",
    description = {
      "Test whether a sensor model is faithful to threshold tables: detection map, trace round the"
          + " obstacle, their errors, and a verdict.",
      "Faithful: agrees with the table at 98 %% of the poses, 3 cm radial and 1 cm lateral error in"
          + " the mean, every bearing reached. Exit status 0 whatever the verdict."
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
      description = "As in simbad run. Default: ${DEFAULT-VALUE}.")
  private String sensor = "shadow";

  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description = "Figures of the sonar. Default: data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Option(
      names = "--speed",
      paramLabel = "M_PER_S",
      description = "Of the robot. Default: ${DEFAULT-VALUE}.")
  private double speedMPerS = RunSettings.THESIS_SPEED_M_PER_S;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Write traces, maps, errors and a page as simbad run does.")
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
        RunFiles.write(staged.path(), new RunOrigin(BuildVersion.text(), settings), results);
        staged.publish();
      }
    }
    for (RunResult result : results) {
      String verdict = FidelityVerdict.of(result, FidelityLimits.STANDARD).sentence();
      out().println(result.type().name() + ", " + result.sensor().word() + ": " + verdict);
      out().println("  " + FidelityVerdict.figures(result));
    }
  }

  private RunSettings settings() throws DataFormatException {
    if (!(speedMPerS > 0 && speedMPerS <= RunSettings.GREATEST_SPEED_M_PER_S)) {
      throw wrongUsage(
          "--speed: "
              + speedMPerS
              + " is not in (0, "
              + RunSettings.GREATEST_SPEED_M_PER_S
              + "] m/s");
    }
    SensorKind kind =
        SensorArgument.parse(sensor)
            .orElseThrow(() -> wrongUsage("--sensor: " + SensorArgument.unknown(sensor)));
    List<ObstacleType> types = new ArrayList<>();
    for (String obstacle : obstacles) {
      types.add(ObstacleArgument.parse(obstacle));
    }
    SonarSpec sonar = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
    return new RunSettings(types, List.of(kind), sonar, speedMPerS, Optional.empty(), 1);
  }
}
