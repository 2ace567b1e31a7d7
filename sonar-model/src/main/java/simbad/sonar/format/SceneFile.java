package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.scene.VerticalExtent;
import simbad.sonar.shape.Crossing;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.Overlap;
import simbad.sonar.shape.ThresholdTable;

/**
 * Scene files: what a simulator believes, {@code format} "sonar-gap/1" or "sonar-gap/2". Of the
 * second format this reads the sensor's law ({@code sensor.model}, {@code sensor.level}), target
 * strengths, vertical extents, mounts of sensors, how well poses are known, and assumptions.
 */
public final class SceneFile {
  private final boolean second;
  private final SonarSpec sensor;

  private SceneFile(boolean second, SonarSpec sensor) {
    this.second = second;
    this.sensor = sensor;
  }

  /**
   * Reads a scene.
   *
   * @param file JSON
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static SensingSetup read(Path file) throws DataFormatException {
    JsonInput root = JsonInput.read(file);
    boolean second = format(root) == DataFormat.SECOND;
    JsonInput sensor = root.field("sensor");
    SonarSpec spec = second ? SensorFile.specWithLaw(sensor) : SensorFile.spec(sensor);
    return new SceneFile(second, spec).setup(root);
  }

  /**
   * Reads of which format a scene is, and the readings beside it.
   *
   * @param file JSON
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static DataFormat format(Path file) throws DataFormatException {
    return format(JsonInput.read(file));
  }

  private static DataFormat format(JsonInput root) throws DataFormatException {
    String word = root.text("format");
    for (DataFormat format : DataFormat.values()) {
      if (word.equals(format.word())) {
        return format;
      }
    }
    throw root.field("format")
        .isNot("\"" + DataFormat.FIRST.word() + "\" or \"" + DataFormat.SECOND.word() + "\"");
  }

  private SensingSetup setup(JsonInput root) throws DataFormatException {
    List<Obstacle> obstacles = new ArrayList<>();
    for (JsonInput item : root.items("obstacles")) {
      Obstacle obstacle = obstacle(item);
      checkOverlap(item, obstacle, obstacles);
      obstacles.add(obstacle);
    }
    SetupDetails details = second ? DetailFields.read(root) : SetupDetails.NONE;
    return new SensingSetup(sensor, new Scene(obstacles), root.positive("no_echo_m"), details);
  }

  private static void checkOverlap(JsonInput item, Obstacle obstacle, List<Obstacle> before)
      throws DataFormatException {
    for (Obstacle other : before) {
      if (Overlap.of(obstacle.worldOutline(), other.worldOutline())) {
        throw item.field("outline_m")
            .fault("obstacle " + obstacle.name() + " overlaps obstacle " + other.name());
      }
    }
  }

  private Obstacle obstacle(JsonInput item) throws DataFormatException {
    Placement placement =
        new Placement(
            item.finite("x_m"), item.finite("z_m"), Math.toRadians(item.finite("turn_deg")));
    return new Obstacle(
        item.label("name"),
        placement,
        outline(item),
        detection(item),
        second ? DetailFields.extent(item) : VerticalExtent.ENDLESS);
  }

  private static Outline outline(JsonInput item) throws DataFormatException {
    List<Point> corners = new ArrayList<>();
    for (JsonInput corner : item.items("outline_m")) {
      List<JsonInput> coordinates = corner.items();
      if (coordinates.size() != 2) {
        throw corner.isNot("a point [x, z]");
      }
      corners.add(new Point(coordinate(coordinates.get(0)), coordinate(coordinates.get(1))));
    }
    try {
      Outline outline = Outline.of(corners);
      Optional<Crossing> crossing = Crossing.findCrossed(outline);
      if (crossing.isPresent()) {
        throw item.field("outline_m")
            .fault(
                "the outline crosses itself: its edges from corner "
                    + (crossing.get().firstEdge() + 1)
                    + " and from corner "
                    + (crossing.get().secondEdge() + 1));
      }
      return outline;
    } catch (IllegalArgumentException e) {
      throw item.field("outline_m").fault(String.valueOf(e.getMessage()));
    }
  }

  private static double coordinate(JsonInput number) throws DataFormatException {
    return number.number(
        value -> Math.abs(value) <= JsonInput.GREATEST, "a finite number, up to 1e6");
  }

  private Detection detection(JsonInput item) throws DataFormatException {
    String word = item.text("detection");
    if (word.equals("table")) {
      return new TableDetection(table(item));
    }
    if (word.equals("uniform")) {
      return new UniformDetection(threshold(item.field("uniform_range_m")));
    }
    if (second && word.equals("strength")) {
      return StrengthDetection.of(strength(item), sensor.levelLaw(), sensor.maxRangeM());
    }
    throw item.field("detection")
        .isNot(second ? "\"table\", \"uniform\" or \"strength\"" : "\"table\" or \"uniform\"");
  }

  private static StrengthTable strength(JsonInput item) throws DataFormatException {
    List<JsonInput> values = item.items("strength_db");
    double[] strengthDb = new double[values.size()];
    for (int i = 0; i < strengthDb.length; i++) {
      strengthDb[i] = values.get(i).number(StrengthTable::isStrength, "a level in [-300, 300] dB");
    }
    if (strengthDb.length == 0) {
      throw item.field("strength_db").fault("is empty, expected at least 1 value");
    }
    return StrengthTable.of(strengthDb);
  }

  private static ThresholdTable table(JsonInput item) throws DataFormatException {
    List<JsonInput> values = item.items("thresholds_m");
    if (values.size() < ThresholdTable.LEAST_SIZE) {
      throw item.field("thresholds_m")
          .fault(values.size() + " values, expected at least " + ThresholdTable.LEAST_SIZE);
    }
    double[] thresholds = new double[values.size()];
    for (int i = 0; i < thresholds.length; i++) {
      thresholds[i] = threshold(values.get(i));
    }
    return ThresholdTable.of(thresholds);
  }

  private static double threshold(JsonInput value) throws DataFormatException {
    return value.number(
        ThresholdTable::isThreshold,
        "a distance in [0, " + ThresholdTable.GREATEST_THRESHOLD_M + "] m");
  }
}
