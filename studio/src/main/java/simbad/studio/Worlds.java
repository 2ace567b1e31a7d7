package simbad.studio;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.scene.SonarSpec;

/**
 * The worlds that were last asked for. A scene that was forgotten is stepped anew and gives the
 * same. Safe for use by several threads.
 */
final class Worlds {
  /** Two beside each other, and what was before the last moves. */
  private static final int KEPT = 6;

  private final List<SensorKind> sensors;
  private final Map<StudioScene, LiveWorld> worlds = new LinkedHashMap<>(16, 0.75f, true);

  /** Creates worlds for sensors: no other can be asked for. */
  Worlds(List<SensorKind> sensors) {
    this.sensors = List.copyOf(sensors);
  }

  List<SensorKind> sensors() {
    return sensors;
  }

  /** The figures of a sensor: a diagnosed one brings its own. */
  static SonarSpec sonar(SensorKind sensor) {
    return sensor.model().map(model -> model.setup().sensor()).orElseGet(Catalogue::srf04);
  }

  /**
   * Answers a question for frames.
   *
   * @param text JSON with scene, from and count
   * @return JSON
   * @throws DataFormatException naming what is wrong with the question
   */
  String frames(String text) throws DataFormatException {
    JsonInput json = StudioScene.question(text);
    int from = StudioScene.step(json.field("from"));
    int count = StudioScene.step(json.field("count"));
    return "{\"frames\":" + world(json.field("scene")).frames(from, count) + "}";
  }

  private synchronized LiveWorld world(JsonInput json) throws DataFormatException {
    StudioScene scene = StudioScene.of(json);
    LiveWorld known = worlds.get(scene);
    if (known != null) {
      return known;
    }
    ObstacleType type =
        Catalogue.findAny(scene.obstacle())
            .orElseThrow(() -> unknown(json, "obstacle", "an obstacle of the catalogue"));
    SensorKind sensor =
        find(scene.sensor()).orElseThrow(() -> unknown(json, "sensor", "one of " + sensors));
    LiveWorld world = new LiveWorld(scene, type, sensor, sonar(sensor));
    worlds.put(scene, world);
    if (worlds.size() > KEPT) {
      worlds.remove(worlds.keySet().iterator().next()).dispose();
    }
    return world;
  }

  private Optional<SensorKind> find(String word) {
    return sensors.stream().filter(kind -> kind.word().equals(word)).findFirst();
  }

  private static DataFormatException unknown(JsonInput json, String field, String expected) {
    try {
      return json.field(field).isNot(expected);
    } catch (DataFormatException e) {
      return e;
    }
  }
}
