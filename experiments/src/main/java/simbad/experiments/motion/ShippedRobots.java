package simbad.experiments.motion;

import java.nio.file.Path;
import java.util.List;
import simbad.motion.MotionChain;
import simbad.motion.format.DiagnosedMotion;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ShippedText;

/** The real robots whose motion comes with the project (data/robots). */
public final class ShippedRobots {
  private static final String FOLDER = "/simbad/experiments/robots/";

  private ShippedRobots() {}

  /** Returns their names. */
  public static List<String> names() {
    return List.of("create-1", "create-2", "create-3");
  }

  /**
   * Returns how a robot moves.
   *
   * @param name one of {@link #names()}
   */
  public static MotionChain motion(String name) {
    String robot = text(name + "/robot.json");
    String model = text(name + "/" + DiagnosedMotion.MODEL);
    try {
      return DiagnosedMotion.parse(Path.of("robots", name), robot, model);
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String text(String file) {
    return ShippedText.read(ShippedRobots.class, FOLDER + file);
  }
}
