package simbad.figures.diagnosis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import simbad.experiments.diagnosis.DiagnosisFolder;
import simbad.experiments.motion.JointFiles;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.joint.JointDiagnosis;
import simbad.gap.locate.PlacementOffset;
import simbad.sonar.format.TextFile;
import simbad.sonar.predict.FittedModel;

/** The folder of a diagnosis of readings, or of a joint log, with its page. */
public final class DiagnosisReport {
  /** The page's name in the folder. */
  public static final String PAGE = "report.html";

  private DiagnosisReport() {}

  /**
   * Writes everything.
   *
   * @param folder exists and is empty
   * @param source the data set's own folder, whose scene is copied
   * @param data what was diagnosed
   * @param diagnosis of it
   * @param provenance what it was made by
   * @return what is off of placements alone, a sentence each without its full stop; none where the
   *     log was not taken place by place along a line
   * @throws IOException if something cannot be written
   */
  public static List<String> write(
      Path folder, Path source, DataSet data, Diagnosis diagnosis, DiagnosisProvenance provenance)
      throws IOException {
    FittedModel model = DiagnosisFolder.write(folder, source, data, diagnosis, provenance);
    List<RowFinding> rows = rows(data, model, provenance);
    TextFile.write(folder.resolve(PAGE), DiagnosisPage.of(diagnosis, data, rows, provenance));
    return LadderPart.of(data, rows).offsets().stream()
        .filter(PlacementOffset::isOff)
        .map(LadderPart::sentence)
        .toList();
  }

  /**
   * Writes everything of a joint log.
   *
   * @param folder exists and is empty
   * @param source the data set's own folder
   * @param log what was diagnosed
   * @param diagnosis of it
   * @param provenance what it was made by
   * @throws IOException if something cannot be written
   */
  public static void write(
      Path folder,
      Path source,
      JointFiles.Log log,
      JointDiagnosis diagnosis,
      DiagnosisProvenance provenance)
      throws IOException {
    FittedModel model = JointFiles.write(folder, source, log, diagnosis, provenance);
    List<RowFinding> rows = rows(log.data(), model, provenance);
    TextFile.write(folder.resolve(PAGE), JointPage.of(log, diagnosis, rows, provenance));
  }

  private static List<RowFinding> rows(
      DataSet data, FittedModel model, DiagnosisProvenance provenance) {
    return RowSurvey.of(data, model.changes(), new SplittableRandom(provenance.seed()));
  }

  /**
   * Writes what there is of a data set that was audited and not diagnosed.
   *
   * @param folder exists and is empty
   * @param data what was audited
   * @param audit what was found
   * @param provenance what it was made by
   * @throws IOException if something cannot be written
   */
  public static void write(
      Path folder, DataSet data, List<AuditFinding> audit, DiagnosisProvenance provenance)
      throws IOException {
    DiagnosisFolder.write(folder, data, audit, provenance);
    TextFile.write(folder.resolve(PAGE), AuditSection.page(data.name(), audit));
  }
}
