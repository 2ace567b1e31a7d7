package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.definition.Effect;
import simbad.experiments.motion.JointFiles;
import simbad.figures.diagnosis.DiagnosisReport;
import simbad.figures.diagnosis.MotionReport;
import simbad.gap.Diagnoser;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.CorrectedScene;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.joint.JointDiagnoser;
import simbad.gap.joint.JointDiagnosis;
import simbad.gap.motion.MotionAudit;
import simbad.gap.motion.MotionDiagnoser;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.StuckTrack;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;
import simbad.sonar.effect.Definitions;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneWriter;
import simbad.sonar.format.TextFile;

/** {@code simbad diagnose}: where simulation and reality part, why, how far the gap shrinks. */
@Command(
    name = "diagnose",
    description = {
      "Say where simulated and real readings differ, which unmodelled effect causes "
          + "the difference, and how far the gap shrinks with that effect in the simulator.",
      "A data set is a folder with scene.json and readings.csv, and perhaps "
          + "reference.csv. Its diagnosis is a folder of the same name in --out, with "
          + "diagnosis.json, model.json and report.html.",
      "A motion folder has robot.json, commands.csv and track.csv. Its diagnosis "
          + "says how the robot's motion differs from what it was told.",
      "A folder with all of these is a joint log. A cause that shows both in the "
          + "readings and in the motion is named once, with one value.",
      "The data are audited before anything is fitted: units, axes, codes for no "
          + "echo, clocks. Data in which no reading can be believed are not diagnosed."
    },
    footer = {
      "",
      "Exit status: 0 every data set was diagnosed, whatever the verdicts; 2 one "
          + "could not be read, or the audit refused it. The others are diagnosed all the "
          + "same.",
      "",
      "Example: simbad diagnose my-bench --out diagnoses",
      "Example: simbad diagnose data/gap/*/ --out diagnoses --json",
      "Example: simbad diagnose my-bench --out audits --audit-only",
      "Example: simbad diagnose my-bench --out diagnoses --corrected my-bench-scene.json"
    })
final class DiagnoseCommand extends Subcommand {
  @Parameters(
      paramLabel = "DATASET",
      arity = "1..*",
      description = "Folders; each holds one data set.")
  private List<Path> folders = List.of();

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Folder for the results. Each data set's diagnosis becomes a new folder in it.")
  private Path out = Path.of("");

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "Seed of the resampling; the same seed gives the same files. Default: ${DEFAULT-VALUE}.")
  private long seed = 1;

  @Option(names = "--json", description = "Print one line of JSON per data set.")
  private boolean json;

  @Option(names = "--audit-only", description = "Only audit the data; fit nothing.")
  private boolean auditOnly;

  @Option(
      names = "--corrected",
      paramLabel = "FILE",
      description =
          "Also write a corrected scene: the believed one with the named effects in it,"
              + " as far as a scene can hold them. For one data set only.")
  private @Nullable Path corrected;

  @Option(
      names = "--withhold",
      paramLabel = "EFFECT",
      completionCandidates = EffectWords.class,
      split = ",",
      hidden = true,
      description = "Effects that the diagnosis shall not know, to check what it calls unknown.")
  private List<String> withhold = List.of();

  private final List<Path> diagnosed = new ArrayList<>();

  /** What is said when all is done. */
  private final List<String> notes = new ArrayList<>();

  @Override
  protected void run() throws Exception {
    Diagnoser diagnoser = new Diagnoser(seed, withheld());
    String version = BuildVersion.text();
    refuseTwins();
    if (corrected != null && (folders.size() != 1 || auditOnly)) {
      throw wrongUsage("--corrected: the scene of one data set is corrected, and after a fit");
    }
    if (corrected != null && Files.isDirectory(corrected)) {
      throw wrongUsage("--corrected: " + corrected + " is a folder, expected a file");
    }
    List<Callable<DataSetSummary>> tasks = new ArrayList<>();
    folders.forEach(folder -> tasks.add(() -> diagnose(folder, diagnoser, version)));
    ExecutorService threads =
        Executors.newFixedThreadPool(
            Math.min(tasks.size(), Runtime.getRuntime().availableProcessors()));
    try (Progress progress = Progress.of("diagnosing", tasks.size())) {
      // In the order of the arguments, whichever is done first.
      List<Future<DataSetSummary>> results = tasks.stream().map(threads::submit).toList();
      for (int i = 0; i < results.size(); i++) {
        await(folders.get(i), results.get(i), progress);
      }
    } finally {
      threads.shutdownNow();
    }
    sayWhatToOpen();
  }

  private void sayWhatToOpen() {
    if (!json) {
      notes.forEach(out()::println);
    }
    if (!json && diagnosed.size() == 1) {
      out().println("report: " + diagnosed.get(0).resolve(DiagnosisReport.PAGE));
    } else if (!json && !diagnosed.isEmpty()) {
      out().println("reports: " + out.resolve("DATASET").resolve(DiagnosisReport.PAGE));
    }
  }

  private void await(Path folder, Future<DataSetSummary> result, Progress progress)
      throws InterruptedException {
    try {
      DataSetSummary summary = result.get();
      progress.clearLine();
      sayFirst(folder, summary);
      out().println(json ? summary.json() : summary.line());
      out().flush();
      diagnosed.add(summary.folder());
    } catch (ExecutionException | DataFormatException fault) {
      progress.clearLine();
      complain(fault);
    }
    progress.step();
  }

  /** What is wrong with data comes before what was made of them. */
  private void sayFirst(Path folder, DataSetSummary summary) throws DataFormatException {
    AuditLines lines = new AuditLines(folder, summary.audit());
    for (AuditFinding finding : summary.audit()) {
      DataFormatException line = lines.complaint(finding);
      if (finding.refuses()) {
        complain(line);
      } else if (!json) {
        out().println(finding.severity().word() + ": " + line.getMessage());
      }
    }
  }

  private DataSetSummary diagnose(Path folder, Diagnoser diagnoser, String version)
      throws IOException, DataFormatException {
    DataSetFolder source = new DataSetFolder(folder);
    Path target = out.resolve(source.name());
    if (MotionFolder.isOne(folder)) {
      return Files.exists(folder.resolve(DataSetFolder.SCENE))
          ? diagnoseJoint(folder, source, diagnoser, version)
          : diagnoseMotion(folder, source, target, version);
    }
    DataSet data = source.read();
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      DiagnosisProvenance provenance = new DiagnosisProvenance(source.sha256(), version, seed);
      List<AuditFinding> audit = Audit.of(data.setup(), data.readings(), data.reference());
      if (auditOnly || Audit.refuses(audit)) {
        DiagnosisReport.write(staged.path(), data, audit, provenance);
        staged.publish();
        return new AuditSummary(data.name(), audit, target);
      }
      Diagnosis diagnosis = diagnoser.diagnose(data, audit);
      DataSet believed = Diagnoser.believed(data, audit);
      List<String> off =
          DiagnosisReport.write(staged.path(), folder, believed, diagnosis, provenance);
      staged.publish();
      if (corrected != null) {
        correct(corrected, CorrectedScene.of(data.setup(), diagnosis));
      }
      return new DiagnoseSummary(data.name(), diagnosis, off, target);
    }
  }

  private void correct(Path file, CorrectedScene scene) throws IOException {
    TextFile.write(file, SceneWriter.text(scene.setup()));
    String put = words(scene.corrected());
    notes.add(file + ": " + (put.isEmpty() ? "the scene, unchanged" : "corrected for " + put));
    if (!scene.elsewhere().isEmpty()) {
      notes.add(
          "a scene has no field for "
              + words(scene.elsewhere())
              + ": use model.json to predict and to drive");
    }
  }

  private static String words(List<Effect> effects) {
    return effects.stream().map(Effect::word).collect(Collectors.joining(", "));
  }

  /** Both halves are read and audited before anything is fitted. */
  private DataSetSummary diagnoseJoint(
      Path folder, DataSetFolder source, Diagnoser diagnoser, String version)
      throws IOException, DataFormatException {
    Path target = out.resolve(source.name());
    DataSet data = source.read();
    MotionFolder drive = new MotionFolder(folder);
    MotionData motion = drive.read(source.name());
    List<AuditFinding> audit =
        new ArrayList<>(Audit.of(data.setup(), data.readings(), data.reference()));
    audit.addAll(MotionAudit.of(drive));
    motion = StuckTrack.without(motion, drive, audit);
    JointFiles.Log log = new JointFiles.Log(data, motion, audit);
    DiagnosisProvenance provenance = new DiagnosisProvenance(source.sha256(), version, seed);
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      if (auditOnly || Audit.refuses(audit)) {
        DiagnosisReport.write(staged.path(), data, audit, provenance);
        staged.publish();
        return new AuditSummary(data.name(), audit, target);
      }
      JointDiagnosis diagnosis = new JointDiagnoser(data, log.drive()).diagnose(diagnoser);
      DiagnosisReport.write(staged.path(), folder, log, diagnosis, provenance);
      staged.publish();
      if (corrected != null) {
        correct(corrected, CorrectedScene.of(data.setup(), diagnosis.sensing()));
      }
      return new JointSummary(log, diagnosis, target);
    }
  }

  private DataSetSummary diagnoseMotion(
      Path folder, DataSetFolder source, Path target, String version)
      throws IOException, DataFormatException {
    if (corrected != null) {
      throw wrongUsage("--corrected: " + folder + " is a motion folder, which has no scene");
    }
    MotionFolder drive = new MotionFolder(folder);
    MotionData all = drive.read(source.name());
    List<AuditFinding> audit = MotionAudit.of(drive);
    MotionData data = StuckTrack.without(all, drive, audit);
    DiagnosisProvenance provenance = new DiagnosisProvenance(source.sha256(), version, seed);
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      if (auditOnly || Audit.refuses(audit)) {
        MotionReport.write(staged.path(), data, audit, provenance);
        staged.publish();
        return new AuditSummary(data.name(), audit, target);
      }
      MotionDiagnosis diagnosis = new MotionDiagnoser(data).diagnose();
      MotionReport.write(staged.path(), data, audit, diagnosis, provenance);
      // What was believed belongs to what was found beside it.
      TextFile.write(
          staged.path().resolve(MotionFolder.ROBOT),
          TextFile.read(folder.resolve(MotionFolder.ROBOT)));
      staged.publish();
      return new MotionSummary(data.name(), audit, diagnosis, target);
    }
  }

  private Set<Effect> withheld() {
    Set<Effect> effects = new LinkedHashSet<>();
    for (String word : withhold) {
      effects.add(
          Definitions.find(word)
              .orElseThrow(() -> wrongUsage("--withhold: " + EffectWords.unknown(word))));
    }
    return effects;
  }

  /** Two data sets of one name would go to one place. */
  private void refuseTwins() throws DataFormatException {
    Map<String, Path> byName = new HashMap<>();
    for (Path folder : folders) {
      Path twin = byName.put(new DataSetFolder(folder).name(), folder);
      if (twin != null) {
        throw wrongUsage(
            "DATASET: "
                + twin
                + " and "
                + folder
                + " are called the same and would share a folder");
      }
    }
    if (Files.exists(out) && !Files.isDirectory(out)) {
      throw wrongUsage("--out: " + out + " is a file, expected a folder");
    }
  }
}
