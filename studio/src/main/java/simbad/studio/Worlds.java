package simbad.studio;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SonarSpec;

/**
 * The worlds that were last asked for. A scene that was forgotten is stepped anew and gives the
 * same. Safe for use by several threads.
 */
final class Worlds {
  /** Two beside each other, and what was before the last moves. */
  private static final int KEPT = 6;

  private final Choices choices;
  private final Map<StudioScene, LiveWorld> worlds = new LinkedHashMap<>(16, 0.75f, true);

  /** Creates worlds of what there is to choose: nothing else can be asked for. */
  Worlds(Choices choices) {
    this.choices = choices;
  }

  /**
   * Answers a question for frames.
   *
   * @param text JSON with scene, from and count, and perhaps every: how many steps lie between two
   * @return JSON
   * @throws DataFormatException naming what is wrong with the question
   */
  String frames(String text) throws DataFormatException {
    JsonInput json = StudioScene.question(text);
    int from = StudioScene.step(json.field("from"));
    int count = StudioScene.step(json.field("count"));
    int every = json.has("every") ? Math.max(1, StudioScene.step(json.field("every"))) : 1;
    return "{\"frames\":" + world(json.field("scene")).frames(from, count, every) + "}";
  }

  /**
   * Reads a scene that was saved on the page.
   *
   * @return its text
   * @throws DataFormatException naming file and field of the first fault
   */
  String scene(Path file) throws DataFormatException {
    String text = TextFile.read(file);
    JsonInput json = JsonInput.parse(file, text);
    world(json);
    boolean alone = !json.has("beside") || json.text("beside").isEmpty();
    if (!alone && choices.findSensor(json.text("beside")).isEmpty()) {
      throw unknown(json, "beside", "one of " + choices.sensors());
    }
    return text;
  }

  private synchronized LiveWorld world(JsonInput json) throws DataFormatException {
    StudioScene scene = StudioScene.of(json);
    LiveWorld known = worlds.get(scene);
    if (known != null) {
      return known;
    }
    ObstacleType type = type(json);
    SensorKind sensor = sensor(json);
    SonarSpec sonar = sonar(json, sensor, scene.sonar());
    SensorKind driven = scene.robot().isEmpty() ? sensor : sensor.on(robot(json, scene.robot()));
    LiveWorld world = new LiveWorld(scene, type, sensor, driven, sonar);
    worlds.put(scene, world);
    if (worlds.size() > KEPT) {
      worlds.remove(worlds.keySet().iterator().next()).dispose();
    }
    return world;
  }

  /**
   * Answers a question for how loud an obstacle's echo is where.
   *
   * @param text JSON with obstacle, sensor and sonar
   * @return JSON
   * @throws DataFormatException naming what is wrong with the question
   */
  String loudness(String text) throws DataFormatException {
    JsonInput json = StudioScene.question(text);
    SensorKind sensor = sensor(json);
    return LoudnessMap.json(sensor, sonar(json, sensor, json.text("sonar")), type(json));
  }

  private static ObstacleType type(JsonInput json) throws DataFormatException {
    return Catalogue.findAny(json.text("obstacle"))
        .orElseThrow(() -> unknown(json, "obstacle", "an obstacle of the catalogue"));
  }

  private SensorKind sensor(JsonInput json) throws DataFormatException {
    return choices
        .findSensor(json.text("sensor"))
        .orElseThrow(() -> unknown(json, "sensor", "one of " + choices.sensors()));
  }

  private static SonarSpec sonar(JsonInput json, SensorKind sensor, String name)
      throws DataFormatException {
    SonarSpec chosen =
        Choices.findSonar(name)
            .orElseThrow(() -> unknown(json, "sonar", "one of " + Catalogue.sonars()));
    return Choices.sonar(sensor, chosen);
  }

  private RobotKind robot(JsonInput json, String name) throws DataFormatException {
    return choices
        .findRobot(name)
        .orElseThrow(
            () ->
                unknown(
                    json,
                    "robot",
                    "one of " + choices.robots().stream().map(RobotKind::name).toList()));
  }

  private static DataFormatException unknown(JsonInput json, String field, String expected) {
    try {
      return json.field(field).isNot(expected);
    } catch (DataFormatException e) {
      return e;
    }
  }
}
