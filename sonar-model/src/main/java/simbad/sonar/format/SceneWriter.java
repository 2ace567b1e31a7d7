package simbad.sonar.format;

import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.UncheckedIOException;
import simbad.sonar.frame.Point;
import simbad.sonar.level.LevelFigures;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.scene.VerticalExtent;

/** Writes what {@link SceneFile} reads. */
public final class SceneWriter {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private SceneWriter() {}

  /**
   * Returns a scene as the text of a file; read again it is the same but for the last digits of its
   * angles, which stand there in degrees. A scene that says which law it believes, states target
   * strengths or heights, or has details, is of format "sonar-gap/2"; any other of "sonar-gap/1".
   *
   * @param setup the scene with its sensor
   */
  public static String text(SensingSetup setup) {
    ObjectNode root = MAPPER.createObjectNode();
    boolean second = isSecond(setup);
    root.put("format", (second ? DataFormat.SECOND : DataFormat.FIRST).word());
    root.put("no_echo_m", setup.noEchoM());
    ObjectNode sensor = root.putObject("sensor");
    addSensor(sensor, setup.sensor());
    if (second) {
      addLaw(sensor, setup.sensor().law());
      DetailFields.write(root, sensor, setup.details());
    }
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

  private static boolean isSecond(SensingSetup setup) {
    return setup.sensor().law().model().isPresent()
        || !setup.details().equals(SetupDetails.NONE)
        || setup.scene().obstacles().stream().anyMatch(SceneWriter::isSecond);
  }

  private static boolean isSecond(Obstacle obstacle) {
    return obstacle.detection() instanceof StrengthDetection
        || !obstacle.extent().equals(VerticalExtent.ENDLESS);
  }

  private static void addLaw(ObjectNode node, SensorLaw law) {
    law.model().ifPresent(model -> node.put(SensorFile.MODEL, model.word()));
    if (!law.level().equals(LevelFigures.NONE)) {
      LevelFields.write(node.putObject(SensorFile.LEVEL), law.level());
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
    DetailFields.writeExtent(node, obstacle.extent());
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
    } else if (obstacle.detection() instanceof StrengthDetection detection) {
      node.put("detection", "strength");
      ArrayNode strengths = node.putArray("strength_db");
      for (double strength : detection.strength().valuesDb()) {
        strengths.add(strength);
      }
    }
  }

  /** A whole degree stays one on its way through radians. */
  static double degrees(double radians) {
    return Math.rint(Math.toDegrees(radians) * 1e9) / 1e9;
  }
}
