package simbad.studio;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/** What there is to choose from, for the page. */
final class CatalogueJson {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private CatalogueJson() {}

  /**
   * Returns obstacles with outlines and shadow edges in metres, sensors, sonars with their figures,
   * and robots.
   *
   * @param scene at which the page opens, as JSON
   * @throws DataFormatException if an obstacle of the user's own cannot be read
   */
  static String of(Choices choices, Optional<String> scene) throws DataFormatException {
    ObjectNode root = MAPPER.createObjectNode();
    scene.ifPresent(json -> root.put("scene", json));
    root.put("step_s", Circuit.STEP_S).put("most_steps", LiveWorld.MOST_STEPS);
    root.put("most_robots", StudioScene.MOST_ROBOTS);
    root.put("most_frames", LiveWorld.MOST_FRAMES).put("sonars", SensorKind.SONARS);
    ArrayNode obstacles = root.putArray("obstacles");
    for (ObstacleType type : Catalogue.all()) {
      add(obstacles.addObject(), type);
    }
    ArrayNode list = root.putArray("sensors");
    for (SensorKind sensor : choices.sensors()) {
      add(list.addObject().put("option", choices.option(sensor.word())), sensor);
    }
    ArrayNode figures = root.putArray("transducers");
    Catalogue.sonars().forEach(name -> add(figures.addObject(), name));
    ArrayNode robots = root.putArray("robots");
    choices
        .robots()
        .forEach(
            robot ->
                robots
                    .addObject()
                    .put("name", robot.name())
                    .put("option", choices.option(robot.name())));
    return root.toString();
  }

  private static void add(ObjectNode node, ObstacleType type) {
    node.put("name", type.name());
    node.put("provenance", type.thresholds().provenanceWord());
    ArrayNode parts = node.putArray("parts");
    type.parts().forEach(part -> add(parts.addArray(), part.corners()));
    add(node.putArray("edge"), type.thresholds().table().points());
    add(node.putArray("original_edge"), OriginalEdge.of(type.outline()));
    node.put("round_m", roundM(type));
  }

  /** The way once round the edge: how long the page's time is. */
  private static double roundM(ObstacleType type) {
    double edgeM =
        type.thresholds().table().greatestM() > 0
            ? Outline.of(type.thresholds().table().points()).perimeterM()
            : 0;
    return Math.max(edgeM, Outline.of(OriginalEdge.of(type.outline())).perimeterM());
  }

  private static void add(ArrayNode to, List<Point> points) {
    points.forEach(point -> to.addArray().add(round(point.xM())).add(round(point.zM())));
  }

  /** To a tenth of a millimetre. */
  private static double round(double metres) {
    return Math.rint(metres * 1e4) / 1e4;
  }

  private static void add(ObjectNode node, String sonar) {
    SonarSpec spec = Choices.findSonar(sonar).orElseThrow();
    node.put("name", sonar);
    node.put("half_angle_deg", Math.toDegrees(spec.coneHalfAngleRad()));
    node.put("max_range_m", spec.maxRangeM());
  }

  /** A diagnosed sensor has a cone of its own; all others that of their sonar. */
  private static void add(ObjectNode node, SensorKind sensor) {
    node.put("name", sensor.word()).put("meaning", sensor.meaning());
    if (sensor.equals(SensorKind.RAY)) {
      node.put("half_angle_deg", 0);
    }
    sensor
        .model()
        .ifPresent(
            model ->
                node.put(
                    "half_angle_deg", Math.toDegrees(model.setup().sensor().coneHalfAngleRad())));
  }
}
