package simbad.sonar.predict;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Rows, logs and what a model says of them. */
public final class Logs {
  public static final OptionalDouble SILENCE = OptionalDouble.empty();

  private Logs() {}

  public static Path golden(String name) {
    return Path.of("..", "sonar-model", "src", "test", "resources", "golden", name);
  }

  public static SensingSetup setup(String golden) throws DataFormatException {
    return SceneFile.read(golden(golden + ".scene.json"));
  }

  /** The golden poses, each with a reading that the nominal model draws there. */
  public static List<ReadingRow> rows(String golden, SensingSetup setup, RandomGenerator random)
      throws DataFormatException {
    NominalModel nominal = new NominalModel(setup.sensor(), setup.scene());
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : ReadingsFile.readPoses(golden(golden + ".rows.csv"))) {
      rows.add(read(row, nominal.distribution(row.pose()).sample(random)));
    }
    return rows;
  }

  public static ReadingRow read(ReadingRow row, Reading reading) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading);
  }

  public static ReadingRow row(double timeS, Pose pose, OptionalDouble rangeM) {
    Reading reading = rangeM.isPresent() ? new Echo(rangeM.getAsDouble()) : NoEcho.NO_ECHO;
    return new ReadingRow("run", "sonar", timeS, pose, reading);
  }

  public static double[] likelihood(
      SensingSetup setup, List<ReadingRow> rows, List<? extends Change> changes) {
    PingLog log = new PingLog(rows);
    ChangedModel model = new ChangedModel(setup, changes);
    double[] probability = new double[log.size()];
    model.likelihood(model.geometry(log), probability);
    return probability;
  }

  public static List<ReadingDistribution> forecast(
      SensingSetup setup, List<ReadingRow> rows, List<? extends Change> changes) {
    ChangedModel model = new ChangedModel(setup, changes);
    return model.forecast(model.geometry(new PingLog(rows)));
  }

  /** All forms of effects and all calibrations. */
  public static List<Form> forms(SensingSetup setup, List<String> sensors) {
    List<Form> forms = new ArrayList<>(Forms.all(setup, sensors));
    forms.addAll(SetupForms.all(setup));
    return forms;
  }
}
