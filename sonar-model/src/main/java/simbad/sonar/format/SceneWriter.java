package simbad.sonar.format;

import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.UncheckedIOException;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;

/** Writes what {@link SceneFile} reads. */
public final class SceneWriter {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private SceneWriter() {}

  /**
   * Returns a scene as the text of a file; read again it is the same but for the last digits of its
   * angles, which stand there in degrees.
   *
   * @param setup the scene with its sensor
   */
  public static String text(SensingSetup setup) {
    ObjectNode root = MAPPER.createObjectNode();
    root.put("format", SceneFile.FORMAT);
    root.put("no_echo_m", setup.noEchoM());
    addSensor(root.putObject("sensor"), setup.sensor());
    ArrayNode obstacles = root.putArray("obstacles");
    setup.scene().obstacles().forEach(obstacle -> addObstacle(obstacles.addObject(), obstacle));
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter().withObjectIndenter(new DefaultIndenter("  ", "\n"));
    try {
      return MAPPER.writer(printer).writeValueAsString(root) + "\n";
    } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void addSensor(ObjectNode node, SonarSpec sensor) {
    node.put("name", sensor.name());
    node.put("cone_half_angle_deg", degrees(sensor.coneHalfAngleRad()));
    node.put("min_range_m", sensor.minRangeM());
    node.put("max_range_m", sensor.maxRangeM());
    node.put("mount_height_m", sensor.mountHeightM());
    node.put("assumed_sound_speed_m_s", sensor.assumedSoundSpeedMPerS());
    node.put("resolution_m", sensor.resolutionM());
    node.put("range_noise_m", sensor.rangeNoiseM());
    node.put("miss_rate", sensor.missRate());
    node.put("edge_width_m", sensor.edgeWidthM());
    node.put("update_period_s", sensor.updatePeriodS());
  }

  private static void addObstacle(ObjectNode node, Obstacle obstacle) {
    node.put("name", obstacle.name());
    node.put("x_m", obstacle.worldFromObstacle().xM());
    node.put("z_m", obstacle.worldFromObstacle().zM());
    node.put("turn_deg", degrees(obstacle.worldFromObstacle().turnRad()));
    ArrayNode outline = node.putArray("outline_m");
    for (Point corner : obstacle.outline().corners()) {
      outline.addArray().add(corner.xM()).add(corner.zM());
    }
    if (obstacle.detection() instanceof TableDetection detection) {
      node.put("detection", "table");
      ArrayNode thresholds = node.putArray("thresholds_m");
      for (double threshold : detection.table().valuesM()) {
        thresholds.add(threshold);
      }
    } else if (obstacle.detection() instanceof UniformDetection detection) {
      node.put("detection", "uniform");
      node.put("uniform_range_m", detection.rangeM());
    }
  }

  /** A whole degree stays one on its way through radians. */
  private static double degrees(double radians) {
    return Math.rint(Math.toDegrees(radians) * 1e9) / 1e9;
  }
}
