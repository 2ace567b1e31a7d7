package simbad.experiments.diagnosis;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensorPoses;

/** Writes the files of a diagnosis's folder. */
public final class DiagnosisFolder {
  /** The fitted model's name in the folder. */
  public static final String MODEL = "model.json";

  private DiagnosisFolder() {}

  /**
   * Writes everything.
   *
   * @param folder exists and is empty
   * @param source the data set's own folder, whose scene is copied
   * @param data what was diagnosed
   * @param diagnosis of it
   * @param provenance what it was made by
   * @return the fitted model
   * @throws IOException if something cannot be written
   */
  public static FittedModel write(
      Path folder, Path source, DataSet data, Diagnosis diagnosis, DiagnosisProvenance provenance)
      throws IOException {
    WholeFile.write(
        folder.resolve(DataSetFolder.SCENE),
        Files.readAllBytes(source.resolve(DataSetFolder.SCENE)));
    save(folder, DiagnosisJson.FILE, DiagnosisJson.text(diagnosis, data, provenance));
    if (diagnosis.nextExperiment().isPresent()) {
      // In the terms of the scene that is copied: a robot's, where it has mounts.
      String poses =
          ReadingsWriter.posesText(
              SensorPoses.undone(data.setup(), diagnosis.nextExperiment().get().poses()));
      save(folder, DiagnosisJson.POSES, poses);
    }
    FittedModel model =
        new FittedModel(
            data.setup(),
            new PingLog(data.readings()).sensors(),
            fitted(diagnosis.calibration()),
            fitted(diagnosis.fitted()));
    ModelFile.write(folder.resolve(MODEL), model);
    return model;
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
    save(folder, DiagnosisJson.FILE, DiagnosisJson.text(audit, data, provenance));
  }

  private static List<FittedForm> fitted(Hypothesis hypothesis) {
    return IntStream.range(0, hypothesis.forms().size())
        .mapToObj(
            i ->
                new FittedForm(
                    hypothesis.forms().get(i),
                    DoubleStream.of(hypothesis.valuesOf(i)).boxed().toList()))
        .toList();
  }

  private static void save(Path folder, String name, String text) throws IOException {
    TextFile.write(folder.resolve(name), text);
  }
}
