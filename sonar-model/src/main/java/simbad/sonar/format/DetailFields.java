package simbad.sonar.format;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.VerticalExtent;

/** The fields of a scene of the second format beside the sensor's law; all may be missing. */
final class DetailFields {
  private static final String POSE_SIGMA = "pose_sigma_m";
  private static final String HEADING_SIGMA = "heading_sigma_deg";
  private static final String SENSORS = "sensors";
  private static final String COMPENSATED = "temperature_compensated";
  private static final String UNKNOWN = "unknown";
  private static final String ASSUMPTIONS = "assumptions";
  private static final String BOTTOM = "bottom_m";
  private static final String TOP = "top_m";
  private static final String X = "x_m";
  private static final String Z = "z_m";
  private static final String TURN = "turn_deg";

  private DetailFields() {}

  static SetupDetails read(JsonInput root) throws DataFormatException {
    return new SetupDetails(
        root.has(POSE_SIGMA) ? root.notNegative(POSE_SIGMA) : 0,
        root.has(HEADING_SIGMA) ? Math.toRadians(root.notNegative(HEADING_SIGMA)) : 0,
        root.has(SENSORS) ? mounts(root.field(SENSORS)) : Map.of(),
        compensated(root.field("sensor")),
        root.has(ASSUMPTIONS) ? texts(root.field(ASSUMPTIONS)) : List.of());
  }

  private static Map<String, Placement> mounts(JsonInput sensors) throws DataFormatException {
    Map<String, Placement> mounts = new LinkedHashMap<>();
    for (String name : sensors.names()) {
      JsonInput mount = sensors.field(name);
      if (!OneLine.isName(name)) {
        throw mount.fault("has a name that is not " + OneLine.NAME);
      }
      mounts.put(
          name,
          new Placement(mount.finite(X), mount.finite(Z), Math.toRadians(mount.finite(TURN))));
    }
    return mounts;
  }

  private static Optional<Boolean> compensated(JsonInput sensor) throws DataFormatException {
    if (!sensor.has(COMPENSATED) || sensor.field(COMPENSATED).isText(UNKNOWN)) {
      return Optional.empty();
    }
    return Optional.of(sensor.field(COMPENSATED).truth());
  }

  private static List<String> texts(JsonInput list) throws DataFormatException {
    List<String> texts = new ArrayList<>();
    for (JsonInput item : list.items()) {
      texts.add(item.text());
    }
    return texts;
  }

  static VerticalExtent extent(JsonInput obstacle) throws DataFormatException {
    double bottomM = obstacle.has(BOTTOM) ? obstacle.finite(BOTTOM) : Double.NEGATIVE_INFINITY;
    if (!obstacle.has(TOP)) {
      return new VerticalExtent(bottomM, Double.POSITIVE_INFINITY);
    }
    double topM =
        obstacle.number(
            TOP,
            value -> value > bottomM && value <= JsonInput.GREATEST,
            "a height above " + BOTTOM + ", up to 1e6");
    return new VerticalExtent(bottomM, topM);
  }

  static void write(ObjectNode root, ObjectNode sensor, SetupDetails details) {
    if (details.poseSigmaM() > 0) {
      root.put(POSE_SIGMA, details.poseSigmaM());
    }
    if (details.headingSigmaRad() > 0) {
      root.put(HEADING_SIGMA, SceneWriter.degrees(details.headingSigmaRad()));
    }
    details.temperatureCompensated().ifPresent(is -> sensor.put(COMPENSATED, is));
    if (!details.robotFromSensor().isEmpty()) {
      ObjectNode sensors = root.putObject(SENSORS);
      details.robotFromSensor().forEach((name, mount) -> add(sensors.putObject(name), mount));
    }
    if (!details.assumptions().isEmpty()) {
      ArrayNode list = root.putArray(ASSUMPTIONS);
      details.assumptions().forEach(list::add);
    }
  }

  private static void add(ObjectNode node, Placement mount) {
    node.put(X, mount.xM());
    node.put(Z, mount.zM());
    node.put(TURN, SceneWriter.degrees(mount.turnRad()));
  }

  static void writeExtent(ObjectNode obstacle, VerticalExtent extent) {
    if (extent.bottomM() > Double.NEGATIVE_INFINITY) {
      obstacle.put(BOTTOM, extent.bottomM());
    }
    if (extent.topM() < Double.POSITIVE_INFINITY) {
      obstacle.put(TOP, extent.topM());
    }
  }
}
