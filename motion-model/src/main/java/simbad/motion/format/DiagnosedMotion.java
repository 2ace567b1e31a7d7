package simbad.motion.format;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import simbad.motion.Capture;
import simbad.motion.CommandReach;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.Robot;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.forecast.PinballLoss;
import simbad.motion.forecast.Spread;
import simbad.motion.forecast.Windows;
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
  private static final String PARAMETERS = "parameters";
  private static final String COMMANDED = "commanded";
  private static final String MAX_SPEED = "max_speed_m_s";
  private static final String MAX_TURN = "max_turn_rad_s";
  private static final String[] COMPONENTS = {"along_m", "across_m", "turn_rad"};
  private static final double MOST = 1e9;
  private static final Set<String> SCATTERING = Set.of(MotionForms.SLIP, MotionForms.MOTION_NOISE);

  private DiagnosedMotion() {}

  /**
   * Reads what a diagnosis left: the mean motion. What only scatters has no part in it, nor has
   * what is about the tracker or its clock, since neither moves the robot.
   *
   * @param folder with robot.json and motion.json
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionChain read(Path folder) throws DataFormatException {
    return mean(model(folder), believedIn(folder));
  }

  /**
   * Tells whether a robot moves otherwise than robot.json believes, by what a diagnosis left.
   *
   * @param folder with robot.json and motion.json
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static boolean changes(Path folder) throws DataFormatException {
    return read(folder).changes().size() > believedIn(folder).motion().changes().size();
  }

  private static Robot believedIn(Path folder) throws DataFormatException {
    return RobotFile.read(folder.resolve(MotionFolder.ROBOT));
  }

  /**
   * Reads the same from texts.
   *
   * @param folder how messages name it
   * @param robot what stands in robot.json
   * @param model what stands in motion.json
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionChain parse(Path folder, String robot, String model)
      throws DataFormatException {
    JsonInput believed = JsonInput.parse(folder.resolve(MotionFolder.ROBOT), robot);
    return mean(JsonInput.parse(folder.resolve(MODEL), model), RobotFile.of(believed));
  }

  private static MotionChain mean(JsonInput json, Robot robot) throws DataFormatException {
    requireFormat(json);
    List<MotionChange> changes = new ArrayList<>(robot.motion().changes());
    for (FittedMotion fitted : forms(json, robot)) {
      boolean moves =
          !fitted.form().clocks() && fitted.change().capture(Capture.CENTRE).equals(Capture.CENTRE);
      if (moves) {
        changes.add(fitted.change());
      }
    }
    return new MotionChain(changes);
  }

  /**
   * Reads the whole model that a diagnosis left, as a forecast of what the tracker reports.
   *
   * @param folder with robot.json and motion.json
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionForecast forecast(Path folder) throws DataFormatException {
    JsonInput json = model(folder);
    requireFormat(json);
    Robot robot = RobotFile.read(folder.resolve(MotionFolder.ROBOT));
    MotionChain chain = robot.motion();
    for (FittedMotion fitted : forms(json, robot)) {
      chain = chain.with(fitted.change());
    }
    List<Spread> spreads = new ArrayList<>();
    for (JsonInput spread : json.items("spread")) {
      spreads.add(spread(spread));
    }
    if (spreads.size() != Windows.horizonsS().length) {
      throw json.field("spread").isNot("a list of " + Windows.horizonsS().length);
    }
    return new MotionForecast(chain, spreads);
  }

  /**
   * Reads what is believed of a robot.
   *
   * @param file robot.json, format "motion-gap/1"
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionChain believed(Path file) throws DataFormatException {
    return robot(file).motion();
  }

  /**
   * Reads all that is believed of a robot and its tracker.
   *
   * @param file robot.json, format "motion-gap/1"
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static Robot robot(Path file) throws DataFormatException {
    return RobotFile.read(file);
  }

  /**
   * Reads how far the commands reached of the log that a diagnosis was made of.
   *
   * @param folder with motion.json; what older programs wrote does not say
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static CommandReach reach(Path folder) throws DataFormatException {
    JsonInput json = model(folder);
    if (!json.has(COMMANDED)) {
      return CommandReach.ANY;
    }
    JsonInput reach = json.field(COMMANDED);
    return new CommandReach(size(reach.field(MAX_SPEED)), size(reach.field(MAX_TURN)));
  }

  private static double size(JsonInput json) throws DataFormatException {
    return json.number(v -> v >= 0 && v <= MOST, "a finite number of at least 0");
  }

  private static JsonInput model(Path folder) throws DataFormatException {
    Path file = folder.resolve(MODEL);
    if (!Files.exists(file)) {
      throw DataFormatException.inFile(
          file, "does not exist, expected what simbad diagnose makes of a motion folder");
    }
    return JsonInput.read(file);
  }

  private static void requireFormat(JsonInput json) throws DataFormatException {
    if (!json.text("format").equals(FORMAT)) {
      throw json.field("format").isNot("\"" + FORMAT + "\"");
    }
  }

  /** What only scatters stood among the forms in files of older programs: it moves nothing. */
  private static List<FittedMotion> forms(JsonInput json, Robot robot) throws DataFormatException {
    List<FittedMotion> forms = new ArrayList<>();
    for (JsonInput one : json.items("forms")) {
      String name = one.text("form");
      if (SCATTERING.contains(name)) {
        continue;
      }
      Optional<MotionForm> found = MotionForms.find(name, robot);
      if (found.isEmpty()) {
        throw one.field("form").isNot("the name of a form of this robot");
      }
      forms.add(new FittedMotion(found.get(), values(found.get(), one.field(PARAMETERS))));
    }
    return forms;
  }

  /** Infinity is no number of JSON: a value whose neutral one it is may be left out. */
  private static double[] values(MotionForm form, JsonInput json) throws DataFormatException {
    double[] values = form.neutralValues();
    for (int i = 0; i < values.length; i++) {
      MotionParameter parameter = form.parameters().get(i);
      if (json.has(parameter.name()) || Double.isFinite(parameter.neutral())) {
        values[i] = number(json.field(parameter.name()), parameter);
      }
    }
    return values;
  }

  private static double number(JsonInput json, MotionParameter parameter)
      throws DataFormatException {
    return json.number(
        v -> (v >= parameter.low() && v <= parameter.high()) || v == parameter.neutral(),
        "in [" + parameter.low() + ", " + parameter.high() + "]");
  }

  private static Spread spread(JsonInput json) throws DataFormatException {
    double[] limits = numbers(json.field("exertion_limits_m"));
    double[][][] quantiles = new double[limits.length + 1][COMPONENTS.length][];
    for (int c = 0; c < COMPONENTS.length; c++) {
      List<JsonInput> classes = json.items(COMPONENTS[c]);
      if (classes.size() != quantiles.length) {
        throw json.field(COMPONENTS[c]).isNot("a list for each class of exertion");
      }
      for (int k = 0; k < quantiles.length; k++) {
        quantiles[k][c] = numbers(classes.get(k));
        if (quantiles[k][c].length != PinballLoss.QUANTILES) {
          throw classes.get(k).isNot("a list of " + PinballLoss.QUANTILES + " quantiles");
        }
      }
    }
    return new Spread(limits, quantiles);
  }

  private static double[] numbers(JsonInput json) throws DataFormatException {
    List<JsonInput> items = json.items();
    double[] numbers = new double[items.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = items.get(i).number(v -> Math.abs(v) <= MOST, "a finite number");
    }
    return numbers;
  }

  /**
   * Returns the text of motion.json, in full precision.
   *
   * @param forms with values; infinite ones are left out
   * @param spreads how far forecasts may be off, by horizon
   * @param reach of the log's commands
   */
  public static String text(List<FittedMotion> forms, List<Spread> spreads, CommandReach reach) {
    StringBuilder text = new StringBuilder("{\n  \"format\": \"" + FORMAT + "\",\n  \"forms\": [");
    String before = "\n";
    for (FittedMotion fitted : forms) {
      text.append(before).append("    {\"form\": \"").append(fitted.form().form());
      text.append("\", \"" + PARAMETERS + "\": {").append(parameters(fitted)).append("}}");
      before = ",\n";
    }
    text.append("\n  ],\n").append(text(reach)).append("  \"spread\": [");
    before = "\n";
    for (int h = 0; h < spreads.size(); h++) {
      text.append(before).append(text(Windows.horizonsS()[h], spreads.get(h)));
      before = ",\n";
    }
    return text.append("\n  ]\n}\n").toString();
  }

  /** Infinity is no number of JSON: what bounds nothing is not said. */
  private static String text(CommandReach reach) {
    return reach.equals(CommandReach.ANY)
        ? ""
        : String.format(
            Locale.ROOT,
            "  \"%s\": {\"%s\": %s, \"%s\": %s},\n",
            COMMANDED,
            MAX_SPEED,
            reach.speedMPerS(),
            MAX_TURN,
            reach.turnRadPerS());
  }

  private static String parameters(FittedMotion fitted) {
    List<String> parameters = new ArrayList<>();
    for (int i = 0; i < fitted.values().length; i++) {
      if (Double.isFinite(fitted.values()[i])) {
        String name = fitted.form().parameters().get(i).name();
        parameters.add("\"" + name + "\": " + fitted.values()[i]);
      }
    }
    return String.join(", ", parameters);
  }

  private static String text(double horizonS, Spread spread) {
    StringBuilder text = new StringBuilder("    {\"horizon_s\": " + horizonS);
    text.append(",\n     \"exertion_limits_m\": ").append(list(spread.limits()));
    for (int c = 0; c < COMPONENTS.length; c++) {
      List<String> classes = new ArrayList<>();
      for (double[][] quantiles : spread.quantiles()) {
        classes.add(list(quantiles[c]));
      }
      text.append(",\n     \"" + COMPONENTS[c] + "\": [");
      text.append(String.join(",\n      ", classes)).append("]");
    }
    return text.append("}").toString();
  }

  private static String list(double[] numbers) {
    return Arrays.toString(numbers);
  }
}
