package simbad.motion.format;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.motion.Capture;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/**
 * How a robot moves: what robot.json believes, and what a diagnosis of motion found beside it
 * (motion.json, format "motion-model/1").
 */
public final class DiagnosedMotion {
  /** What a diagnosis found. */
  public static final String MODEL = "motion.json";

  private static final String FORMAT = "motion-model/1";

  private DiagnosedMotion() {}

  /**
   * Reads what a diagnosis left: the mean motion. What only scatters has no part in it, nor has
   * what is about the tracker or its clock, since neither moves the robot.
   *
   * @param folder with robot.json and motion.json
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionChain read(Path folder) throws DataFormatException {
    Path file = folder.resolve(MODEL);
    if (!Files.exists(file)) {
      throw DataFormatException.inFile(
          file, "does not exist, expected what simbad diagnose makes of a motion folder");
    }
    JsonInput json = JsonInput.read(file);
    if (!json.text("format").equals(FORMAT)) {
      throw json.field("format").isNot("\"" + FORMAT + "\"");
    }
    List<MotionChange> changes =
        new ArrayList<>(RobotFile.read(folder.resolve(MotionFolder.ROBOT)).motion().changes());
    for (JsonInput form : json.items("forms")) {
      change(form).ifPresent(changes::add);
    }
    return new MotionChain(changes);
  }

  /**
   * Reads what is believed of a robot.
   *
   * @param file robot.json, format "motion-gap/1"
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionChain believed(Path file) throws DataFormatException {
    return RobotFile.read(file).motion();
  }

  private static Optional<MotionChange> change(JsonInput json) throws DataFormatException {
    String name = json.text("form");
    if (name.equals(MotionForms.MOTION_NOISE) || name.equals(MotionForms.SLIP)) {
      return Optional.empty();
    }
    Optional<MotionForm> found = MotionForms.find(name);
    if (found.isEmpty()) {
      throw json.field("form").isNot("the name of a form");
    }
    MotionForm form = found.get();
    JsonInput values = json.field("parameters");
    double[] numbers = new double[form.parameters().size()];
    for (int i = 0; i < numbers.length; i++) {
      MotionParameter parameter = form.parameters().get(i);
      numbers[i] = number(values.field(parameter.name()), parameter);
    }
    MotionChange change = form.change(numbers);
    boolean moves = !form.clocks() && change.capture(Capture.CENTRE).equals(Capture.CENTRE);
    return moves ? Optional.of(change) : Optional.empty();
  }

  private static double number(JsonInput json, MotionParameter parameter)
      throws DataFormatException {
    return json.number(
        v -> (v >= parameter.low() && v <= parameter.high()) || v == parameter.neutral(),
        "in [" + parameter.low() + ", " + parameter.high() + "]");
  }
}
