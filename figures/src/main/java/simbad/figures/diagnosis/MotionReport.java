package simbad.figures.diagnosis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simbad.experiments.motion.MotionFiles;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.motion.MotionDiagnosis;
import simbad.motion.format.MotionData;
import simbad.sonar.format.TextFile;

/** The folder of a diagnosis of motion with its page. */
public final class MotionReport {
  private MotionReport() {}

  /**
   * Writes everything.
   *
   * @param folder that is there
   * @param data what was diagnosed
   * @param audit what was found of the data
   * @param diagnosis of it
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder,
      MotionData data,
      List<AuditFinding> audit,
      MotionDiagnosis diagnosis,
      DiagnosisProvenance provenance)
      throws IOException {
    MotionFiles.write(folder, data, audit, diagnosis, provenance);
    TextFile.write(
        folder.resolve(DiagnosisReport.PAGE), MotionPage.of(data, audit, diagnosis, provenance));
  }

  /**
   * Writes what the audit found where nothing was fitted.
   *
   * @param folder that is there
   * @param data what was audited
   * @param audit what was found
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder, MotionData data, List<AuditFinding> audit, DiagnosisProvenance provenance)
      throws IOException {
    MotionFiles.write(folder, data, audit, provenance);
    TextFile.write(folder.resolve(DiagnosisReport.PAGE), AuditSection.page(data.name(), audit));
  }
}
