package simbad.figures.diagnosis;

import java.io.IOException;
import java.nio.file.Path;
import simbad.experiments.motion.MotionFiles;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.motion.MotionDiagnosis;
import simbad.sonar.format.TextFile;

/** The folder of a diagnosis of motion with its page. */
public final class MotionReport {
  private MotionReport() {}

  /**
   * Writes everything.
   *
   * @param folder that is there
   * @param dataset name of the data set
   * @param diagnosis of it
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder, String dataset, MotionDiagnosis diagnosis, Provenance provenance)
      throws IOException {
    MotionFiles.write(folder, dataset, diagnosis, provenance);
    TextFile.write(
        folder.resolve(DiagnosisReport.PAGE), MotionPage.of(dataset, diagnosis, provenance));
  }
}
