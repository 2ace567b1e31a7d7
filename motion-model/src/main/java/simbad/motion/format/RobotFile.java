package simbad.motion.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.TextFile;

/** robot.json, format "motion-gap/1". */
final class RobotFile {
  private static final String FORMAT = "motion-gap/1";

  private RobotFile() {}

  static Robot read(Path file) throws DataFormatException {
    return of(JsonInput.parse(file, TextFile.read(file)));
  }

  static Robot of(JsonInput json) throws DataFormatException {
    if (!json.text("format").equals(FORMAT)) {
      throw json.field("format").isNot("\"" + FORMAT + "\"");
    }
    boolean differential = differential(json);
    return new Robot(
        differential,
        differential ? positive(json, "wheel_base_m") : 0,
        separateClocks(json),
        atLeast0(json, "track_sigma_m"),
        Math.toRadians(atLeast0(json, "track_sigma_deg")),
        believed(json));
  }

  private static boolean differential(JsonInput json) throws DataFormatException {
    String word = json.text("kinematics");
    if (!word.equals("unicycle") && !word.equals("differential")) {
      throw json.field("kinematics").isNot("\"unicycle\" or \"differential\"");
    }
    if (json.has("wheel_radius_m")) {
      positive(json, "wheel_radius_m");
    }
    return word.equals("differential");
  }

  private static boolean separateClocks(JsonInput json) throws DataFormatException {
    if (!json.has("clocks")) {
      return false;
    }
    String word = json.text("clocks");
    if (!word.equals("separate") && !word.equals("one")) {
      throw json.field("clocks").isNot("\"separate\" or \"one\"");
    }
    return word.equals("separate");
  }

  /** What the simulator believes is a chain of the same changes that a diagnosis finds. */
  private static MotionChain believed(JsonInput json) throws DataFormatException {
    List<MotionChange> changes = new ArrayList<>();
    add(changes, "actuation-latency", optional(json, "latency_s"));
    add(
        changes,
        "actuation-lag: time constants",
        optional(json, "speed_time_constant_s"),
        optional(json, "turn_time_constant_s"));
    add(
        changes,
        "actuation-lag: greatest acceleration",
        limit(json, "max_acceleration_m_s2"),
        limit(json, "max_turn_acceleration_rad_s2"));
    add(changes, "dead-band", optional(json, "dead_band_m_s"), optional(json, "dead_band_rad_s"));
    add(changes, "saturation: speed", limit(json, "max_speed_m_s"));
    add(changes, "saturation: turning", limit(json, "max_turn_rad_s"));
    return new MotionChain(changes);
  }

  private static void add(List<MotionChange> changes, String form, Value... values)
      throws DataFormatException {
    MotionForm found = MotionForms.find(form).orElseThrow();
    double[] numbers = new double[values.length];
    boolean any = false;
    for (int i = 0; i < values.length; i++) {
      numbers[i] = values[i].orNeutral(found.parameters().get(i).neutral());
      any |= numbers[i] != found.parameters().get(i).neutral();
    }
    if (any) {
      for (int i = 0; i < values.length; i++) {
        values[i].requireWithin(found.parameters().get(i).low(), found.parameters().get(i).high());
      }
      changes.add(found.change(numbers));
    }
  }

  /** A field that may be missing; where 0 stands for "no limit", it counts as missing. */
  private record Value(JsonInput json, String field, double number) {
    double orNeutral(double neutral) {
      return Double.isNaN(number) ? neutral : number;
    }

    void requireWithin(double low, double high) throws DataFormatException {
      if (number < low || number > high) {
        throw json.field(field).isNot("a number in [" + low + ", " + high + "]");
      }
    }
  }

  private static Value optional(JsonInput json, String field) throws DataFormatException {
    return new Value(json, field, json.has(field) ? atLeast0(json, field) : Double.NaN);
  }

  private static Value limit(JsonInput json, String field) throws DataFormatException {
    Value value = optional(json, field);
    return value.number() == 0 ? new Value(json, field, Double.NaN) : value;
  }

  private static double atLeast0(JsonInput json, String field) throws DataFormatException {
    if (!json.has(field)) {
      return 0;
    }
    return json.field(field).number(v -> v >= 0 && v <= 1e6, "a number of at least 0, up to 1e6");
  }

  private static double positive(JsonInput json, String field) throws DataFormatException {
    return json.field(field).number(v -> v > 0 && v <= 1e6, "a number above 0, up to 1e6");
  }

  static String unicycle(Robot robot) {
    if (robot.differential() || !robot.motion().changes().isEmpty()) {
      throw new IllegalArgumentException("only an exact body that goes and turns is written");
    }
    return String.format(
            Locale.ROOT,
            "{%n  \"format\": \"%s\",%n  \"kinematics\": \"unicycle\",%n"
                + "  \"clocks\": \"%s\",%n  \"track_sigma_m\": %s,%n  \"track_sigma_deg\": %s%n}%n",
            FORMAT,
            robot.separateClocks() ? "separate" : "one",
            robot.trackSigmaM(),
            Math.toDegrees(robot.trackSigmaRad()))
        .replace(System.lineSeparator(), "\n");
  }
}
