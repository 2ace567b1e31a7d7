package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simbad.experiments.diagnosis.DiagnosisFolder;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneFile;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.shape.Outline;

/** The folder of a diagnosis of sensing: what it says, its scene, its curves, the rows. */
final class SensingView {
  private final ObjectNode root;
  private final FittedModel model;

  private SensingView(ObjectNode root, FittedModel model) {
    this.root = root;
    this.model = model;
  }

  /**
   * Adds what a diagnosis left. One that was only audited has no more than its JSON.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static void add(Path folder, DataSets sets, ObjectNode root) throws DataFormatException {
    JsonNode diagnosis = JsonText.read(Shelf.file(folder, "diagnosis.json"));
    root.set("diagnosis", diagnosis);
    Path scene = Shelf.file(folder, DataSetFolder.SCENE);
    if (!Files.exists(scene)) {
      return;
    }
    SensingSetup setup = SceneFile.read(scene);
    Path file = Shelf.file(folder, DiagnosisFolder.MODEL);
    SensingView view = new SensingView(root, ModelFile.read(file, setup));
    view.obstacles();
    DataSets.Found found = sets.find(diagnosis);
    root.put("missing", found.missing());
    if (found.folder().isPresent()) {
      new RowsView(new DataSetFolder(found.folder().get()).read(), view.model).add(diagnosis, root);
    }
  }

  private void obstacles() {
    ArrayNode list = root.putArray("obstacles");
    for (Obstacle obstacle : model.setup().scene().obstacles()) {
      ObjectNode node = list.addObject();
      node.put("name", obstacle.name());
      RunView.addCorners(obstacle.worldOutline(), node.putArray("outline"));
      node.put("x_m", obstacle.worldFromObstacle().xM());
      node.put("z_m", obstacle.worldFromObstacle().zM());
      node.put("turn_rad", obstacle.worldFromObstacle().turnRad());
      curves(obstacle, node);
    }
  }

  /** The obstacle stands alone: on its bearings another one would be heard. */
  private void curves(Obstacle obstacle, ObjectNode node) {
    SensingSetup alone = model.setup().with(new Scene(List.of(obstacle)));
    Outline outline = obstacle.outline();
    double mostM = 1.5 * (alone.sensor().maxRangeM() + outline.reachM(0, 0));
    ChangedModel believed = new ChangedModel(alone, List.of());
    ChangedModel fitted = new ChangedModel(alone, model.changes());
    String sensor = model.sensors().isEmpty() ? "sensor" : model.sensors().get(0);
    put(node.putArray("believed_m"), Reach.of(believed, obstacle, sensor, mostM));
    put(node.putArray("fitted_m"), Reach.of(fitted, obstacle, sensor, mostM));
  }

  private static void put(ArrayNode list, double[] valuesM) {
    for (double valueM : valuesM) {
      list.add(Math.rint(valueM * 1e4) / 1e4);
    }
  }
}
