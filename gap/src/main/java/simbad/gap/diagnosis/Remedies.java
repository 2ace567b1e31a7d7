package simbad.gap.diagnosis;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import simbad.sonar.effect.Effect;
import simbad.sonar.scene.SonarSpec;

/** What to do about each effect that is named: one sentence with its number. */
public final class Remedies {
  private static final double DEGREES_OF_AIR = 0.606;
  private static final double FREEZING_M_S = 331.3;

  /** Air between these is air; any other speed is a wrong constant or a wrong unit. */
  private static final double COLDEST_M_S = 318;

  private static final double HOTTEST_M_S = 362;

  private static final double CM = 100;

  private final SonarSpec sensor;
  private final Map<String, Double> values;

  private Remedies(SonarSpec sensor, List<FittedParameter> parameters) {
    this.sensor = sensor;
    values =
        parameters.stream()
            .collect(Collectors.toMap(FittedParameter::name, FittedParameter::value, (a, b) -> a));
  }

  /**
   * Returns the remedy of an effect.
   *
   * @param finding of the effect, with fitted values
   * @param sensor as the simulator believes it
   */
  public static String of(EffectFinding finding, SonarSpec sensor) {
    Remedies own = new Remedies(sensor, finding.parameters());
    return own.ofNumbers(finding.effect());
  }

  /** Of what is made of a range. */
  private String ofNumbers(Effect effect) {
    return switch (effect) {
      case SOUND_SPEED -> speed();
      case RANGE_OFFSET ->
          text(
              value("offset_m") < 0
                  ? "add %.1f cm to every reading"
                  : "take %.1f cm from every reading",
              CM * Math.abs(value("offset_m")));
      case COARSE_RESOLUTION -> text("let the sensor's resolution_m be %.4g", value("step_m"));
      case RANGE_NOISE ->
          "let the sensor's range_noise_m be what is fitted here, or average readings";
      case NEAR_CLAMP ->
          text(
              "take readings of %.3f m for nearer than that, not for a distance", value("least_m"));
      case NO_ECHO_CODE -> text("read %.3f m as no echo, not as a distance", value("code_m"));
      case WRAP ->
          text("use a wider number: readings begin again after %.3f m", value("modulus_m"));
      case WAVE_HOP -> "raise the echo's level, or take the least of a few readings";
      case LATENCY -> "stamp readings with the time of the ping, not with that of their arrival";
      case STALE_READING -> "report a missed echo as such: do not repeat the reading before";
      case PREVIOUS_PING ->
          "wait longer between pings, until the echoes of the one before have died";
      default -> ofEchoes(effect);
    };
  }

  /** Of what is heard, and what else is. */
  private String ofEchoes(Effect effect) {
    return switch (effect) {
      case CROSSTALK -> "let no two sonars ping at one time, and take the median of three readings";
      case MULTIPATH ->
          "cover or move what reflects beside the way, and take the least of readings";
      case DROPOUT ->
          text(
              "let the sensor's miss_rate be %.2g, or ping again where nothing is heard",
              value("share"));
      case GAIN ->
          text(
              "multiply all thresholds by %.2f, or restore the sensor's drive voltage",
              value("factor"));
      case ABSORPTION -> "shorten the far thresholds, or log the air's temperature and humidity";
      case BEAM_PATTERN -> "give the sensor its beam off the axis: thresholds there are shorter";
      case BEAM_WIDTH ->
          text(
              "let cone_half_angle_deg be %.1f",
              Math.toDegrees(sensor.coneHalfAngleRad()) + value("added_deg"));
      case FLOOR_ECHO ->
          text(
              "raise or tilt the sensor: something answers at %.2f m whatever stands there",
              value("range_m"));
      case HYSTERESIS -> "measure thresholds both ways, towards the obstacle and away from it";
      case DEAD_ZONE -> text("let min_range_m be %.3f", value("end_m"));
      case EARLY_TIMEOUT ->
          text("let max_range_m be %.2f, or wait longer for the echo", value("start_m"));
      default -> ofPlaces(effect);
    };
  }

  /** Of where things stand and look. */
  private String ofPlaces(Effect effect) {
    return switch (effect) {
      case BEAM_MISALIGNMENT -> turned();
      case UNMODELLED_OBJECT ->
          text(
              "look at x = %.2f m, z = %.2f m, and put what stands there into the scene",
              value("x_m"), value("z_m"));
      case OBSTACLE_TURN -> text("turn the obstacle's turn_deg by %+.1f", value("turn_deg"));
      case OBSTACLE_OFFSET ->
          text("move the obstacle by %+.3f m in x and %+.3f m in z", value("x_m"), value("z_m"));
      case ODOMETRY_SCALE -> "calibrate the odometry's way: it is off by a factor";
      case HEADING_DRIFT -> "correct the heading's drift, or reset it from time to time";
      case ORIENTATION_SHADOW -> "give the obstacle a threshold table instead of one range";
      case PLACEMENT_ERROR ->
          text(
              "place things to better than %.1f cm, or give pose_sigma_m",
              CM * value("deviation_m"));
      default -> throw new IllegalArgumentException(effect + " has no remedy");
    };
  }

  private String speed() {
    double speed = value("sound_speed_m_s");
    if (speed < COLDEST_M_S || speed > HOTTEST_M_S) {
      return text(
          "multiply readings by %.4g: that is a unit or a constant, not the air",
          speed / sensor.assumedSoundSpeedMPerS());
    }
    return text(
        "compute with %.1f m/s (air of %.0f degrees), not %.1f",
        speed, (speed - FREEZING_M_S) / DEGREES_OF_AIR, sensor.assumedSoundSpeedMPerS());
  }

  private String turned() {
    double degrees = value("turn_deg");
    return values.containsKey("turn_deg")
        ? text(
            "turn the sensor %.1f degrees to the %s",
            Math.abs(degrees), degrees > 0 ? "right" : "left")
        : "straighten the sensor that looks aside";
  }

  private double value(String name) {
    return values.getOrDefault(name, Double.NaN);
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
