package simbad.cli;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.diagnosis.DiagnosisFolder;
import simbad.experiments.diagnosis.Predictions;
import simbad.experiments.motion.MotionPredictions;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.gap.motion.MotionAudit;
import simbad.motion.MotionRun;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.format.DiagnosedMotion;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.format.TextFile;
import simbad.sonar.ping.Change;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorPoses;
import simbad.sonar.sensing.ReadingRow;

/** {@code simbad predict}: the distribution of readings on rows never seen. */
@Command(
    name = "predict",
    description = {
      "Predict the readings at the poses of some rows: 19 quantiles per row.",
      "A no-echo counts as the scene's no_echo_m.",
      "Rows may come in any order; the predictions have the same order. A column "
          + "range_m is ignored.",
      "A diagnosis of motion predicts a motion folder from its commands: for each "
          + "window of 0.5, 2 and 5 s the quantiles of the way along, the way across and "
          + "the turn."
    },
    footer = {
      "",
      "Example: simbad predict diagnoses/my-bench rows.csv --out predictions.csv",
      "Example: simbad predict diagnoses/my-bench rows.csv --out nominal.csv --model nominal",
      "Example: simbad predict diagnoses/my-robot another-drive --out windows.csv"
    })
final class PredictCommand extends Subcommand {
  /** Which model predicts. */
  private enum Model {
    NOMINAL,
    DIAGNOSED
  }

  @Parameters(paramLabel = "DIAGNOSIS_DIR", description = "A folder that diagnose wrote.")
  private Path diagnosis = Path.of("");

  @Parameters(
      paramLabel = "ROWS.csv",
      description =
          "run,sensor,t_s,x_m,z_m,heading_deg and any further columns. For a diagnosis "
              + "of motion: a motion folder.")
  private Path rows = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "FILE",
      required = true,
      description = "A file that does not exist yet.")
  private Path out = Path.of("");

  @Option(
      names = "--model",
      paramLabel = "nominal|diagnosed",
      description =
          "nominal: the simulator as it is; diagnosed: the simulator with what was "
              + "fitted. Default: diagnosed.")
  private String model = "diagnosed";

  @Override
  protected void run() throws Exception {
    Model chosen = model();
    if (Files.exists(out) && (Files.isDirectory(out) || Files.size(out) > 0)) {
      throw new FileAlreadyExistsException(out.toString());
    }
    Path scene = diagnosis.resolve(DataSetFolder.SCENE);
    if (MotionFolder.isOne(rows) || (Files.isDirectory(rows) && !Files.exists(scene))) {
      write(motion(chosen));
      return;
    }
    if (!Files.exists(scene) && Files.exists(diagnosis.resolve(DiagnosedMotion.MODEL))) {
      throw DataFormatException.inFile(
          rows,
          "is no folder, expected a motion folder: " + diagnosis + " is a diagnosis of motion");
    }
    SensingSetup setup = SceneFile.read(scene);
    List<? extends Change> changes = chosen == Model.NOMINAL ? List.of() : changes(setup);
    List<ReadingRow> poses = ReadingsFile.readPoses(rows, SceneFile.format(scene));
    Optional<String> problem = SensorPoses.problem(setup, poses);
    if (problem.isPresent()) {
      throw DataFormatException.inFile(rows, problem.get());
    }
    write(Predictions.text(setup, changes, SensorPoses.of(setup, poses)));
  }

  /** The folder that is forecast may believe something else; what was diagnosed counts. */
  private String motion(Model chosen) throws DataFormatException {
    MotionForecast forecast =
        chosen == Model.NOMINAL
            ? MotionForecast.believed(DiagnosedMotion.robot(diagnosis.resolve(MotionFolder.ROBOT)))
            : DiagnosedMotion.forecast(diagnosis);
    String name = new DataSetFolder(rows).name();
    MotionFolder drive = new MotionFolder(rows);
    List<MotionRun> runs = drive.read(name).runs();
    List<AuditFinding> audit = MotionAudit.of(drive);
    for (AuditFinding finding : audit) {
      // Windows can be foretold of a track that is wrong in another way.
      if (finding.refuses() && finding.check() == AuditCheck.TRACK_CLOCK) {
        throw new AuditLines(rows, audit).complaint(finding);
      }
    }
    return MotionPredictions.text(forecast, runs);
  }

  private void write(String text) throws IOException {
    Path folder = out.toAbsolutePath().getParent();
    if (folder != null) {
      Files.createDirectories(folder);
    }
    TextFile.write(out, text);
  }

  private List<? extends Change> changes(SensingSetup setup) throws DataFormatException {
    return ModelFile.read(diagnosis.resolve(DiagnosisFolder.MODEL), setup).changes();
  }

  private Model model() {
    return switch (model) {
      case "nominal" -> Model.NOMINAL;
      case "diagnosed" -> Model.DIAGNOSED;
      default -> throw wrongUsage("--model: '" + model + "' is neither nominal nor diagnosed");
    };
  }
}
