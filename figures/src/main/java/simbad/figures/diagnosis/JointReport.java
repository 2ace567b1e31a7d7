package simbad.figures.diagnosis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import simbad.experiments.motion.JointFiles;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.joint.JointDiagnosis;
import simbad.sonar.format.TextFile;
import simbad.sonar.predict.FittedModel;

/** The folder of a joint log's diagnosis with its page. */
public final class JointReport {
  private JointReport() {}

  /**
   * Writes everything.
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
    List<RowFinding> rows =
        RowSurvey.of(log.data(), model.changes(), new SplittableRandom(provenance.seed()));
    TextFile.write(
        folder.resolve(DiagnosisReport.PAGE), JointPage.of(log, diagnosis, rows, provenance));
  }
}
