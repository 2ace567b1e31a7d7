package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.level.LevelFigures;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;

/**
 * Sensors as JSON files, with the fields of {@code sensor} in a scene file, {@code level} among
 * them.
 */
public final class SensorFile {
  private static final double LARGEST_HALF_ANGLE_DEG = 180;

  private static final String SENSITIVITY = "sensitivity_db";

  static final String MODEL = "model";

  static final String LEVEL = "level";

  private SensorFile() {}

  /**
   * Reads a sensor.
   *
   * @param file JSON
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static SonarSpec read(Path file) throws DataFormatException {
    return specWithLevel(JsonInput.read(file));
  }

  /**
   * Reads a sensor from a text that was read already.
   *
   * @param name how messages name the text
   * @param text JSON
   * @throws DataFormatException naming name, line and field of the first fault
   */
  public static SonarSpec parse(Path name, String text) throws DataFormatException {
    return specWithLevel(JsonInput.parse(name, text));
  }

  /**
   * Reads the curve of a sensor's sensitivity, fields {@code sensitivity_db} (pairs of degrees off
   * the axis and decibels) and {@code sensitivity_source}.
   *
   * @param file JSON
   * @return empty if the file has none
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static Optional<Sensitivity> findSensitivity(Path file) throws DataFormatException {
    JsonInput sensor = JsonInput.read(file);
    if (!sensor.has(SENSITIVITY)) {
      return Optional.empty();
    }
    List<Sensitivity.Point> points = new ArrayList<>();
    for (JsonInput pair : sensor.items(SENSITIVITY)) {
      List<JsonInput> numbers = pair.items();
      if (numbers.size() != 2) {
        throw pair.isNot("a pair [degrees off the axis, dB]");
      }
      points.add(
          new Sensitivity.Point(
              numbers.get(0).number(a -> a >= 0 && a <= 180, "an angle in [0, 180] degrees"),
              numbers.get(1).number(db -> db <= 0 && db >= -200, "a level in [-200, 0] dB")));
    }
    try {
      return Optional.of(new Sensitivity(sensor.text("sensitivity_source"), points));
    } catch (IllegalArgumentException e) {
      throw sensor.field(SENSITIVITY).fault(String.valueOf(e.getMessage()));
    }
  }

  static SonarSpec spec(JsonInput sensor) throws DataFormatException {
    double halfAngleDeg =
        sensor.number(
            "cone_half_angle_deg",
            // Of the smallest angles nothing is left in radians.
            angle -> Math.toRadians(angle) > 0 && angle <= LARGEST_HALF_ANGLE_DEG,
            "an angle in (0, 180] degrees");
    double minRangeM = sensor.notNegative("min_range_m");
    return new SonarSpec(
        sensor.label("name"),
        Math.toRadians(halfAngleDeg),
        minRangeM,
        sensor.number(
            "max_range_m",
            range -> range > minRangeM && range <= JsonInput.GREATEST,
            "a range above min_range_m = " + minRangeM + ", up to 1e6"),
        sensor.notNegative("mount_height_m"),
        sensor.positive("assumed_sound_speed_m_s"),
        sensor.notNegative("resolution_m"),
        sensor.notNegative("range_noise_m"),
        sensor.number("miss_rate", rate -> rate >= 0 && rate <= 1, "a share in [0, 1]"),
        sensor.notNegative("edge_width_m"),
        sensor.positive("update_period_s"));
  }

  /** A file of a sensor alone believes no law: what uses it says by which one it hears. */
  private static SonarSpec specWithLevel(JsonInput sensor) throws DataFormatException {
    return spec(sensor).withLaw(new SensorLaw(Optional.empty(), level(sensor)));
  }

  /** The sensor of a scene of the second format. */
  static SonarSpec specWithLaw(JsonInput sensor) throws DataFormatException {
    Optional<SensorLaw.Model> model = Optional.empty();
    if (sensor.has(MODEL)) {
      model = Optional.of(model(sensor.field(MODEL)));
    }
    return spec(sensor).withLaw(new SensorLaw(model, level(sensor)));
  }

  private static LevelFigures level(JsonInput sensor) throws DataFormatException {
    return sensor.has(LEVEL) ? LevelFields.read(sensor.field(LEVEL)) : LevelFigures.NONE;
  }

  private static SensorLaw.Model model(JsonInput word) throws DataFormatException {
    for (SensorLaw.Model model : SensorLaw.Model.values()) {
      if (word.isText(model.word())) {
        return model;
      }
    }
    throw word.isNot("\"threshold\" or \"level\"");
  }
}
