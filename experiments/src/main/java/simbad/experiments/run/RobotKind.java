package simbad.experiments.run;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import simbad.motion.CommandReach;
import simbad.motion.MotionChain;
import simbad.motion.format.DiagnosedMotion;
import simbad.sonar.format.DataFormatException;

/**
 * A robot that does not do exactly what it is told.
 *
 * @param name in files and tables; what cannot stand in a file's name becomes a hyphen
 * @param motion how it moves
 * @param reach of the commands that it was seen under
 */
public record RobotKind(String name, MotionChain motion, CommandReach reach) {
  /** Makes the name one of a file. */
  public RobotKind {
    name = name.replaceAll("[^A-Za-z0-9_.-]", "-");
    if (name.isEmpty()) {
      throw new IllegalArgumentException("a robot needs a name");
    }
  }

  /**
   * Describes a robot of which no log is known.
   *
   * @param name in files and tables
   * @param motion how it moves
   */
  public RobotKind(String name, MotionChain motion) {
    this(name, motion, CommandReach.ANY);
  }

  /**
   * Says that a run asks for more than is known of the robot; empty where it does not.
   *
   * @param speedMPerS greatest that is asked for
   * @param turnRadPerS the same of the rate of turning
   */
  public Optional<String> beyond(double speedMPerS, double turnRadPerS) {
    return reach.holds(speedMPerS, turnRadPerS)
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "the log of %s has commands of up to %.3g m/s and %.3g rad/s, this run asks for up"
                    + " to %.3g m/s and %.3g rad/s: how the robot moves there is not known",
                name,
                reach.speedMPerS(),
                reach.turnRadPerS(),
                speedMPerS,
                turnRadPerS));
  }

  /**
   * Reads a robot of the command line.
   *
   * @param word "diagnosed:" and the folder that a diagnosis of motion left, or a robot.json
   * @throws DataFormatException if a file is missing or wrong
   */
  public static RobotKind read(String word) throws DataFormatException {
    Optional<String> diagnosed = DiagnosedFolder.in(word);
    return diagnosed.isPresent() ? diagnosed(Path.of(diagnosed.get())) : believed(Path.of(word));
  }

  /**
   * Says that nothing of a diagnosis moves the robot; empty where something does, and for a file.
   *
   * @param word as in {@link #read}
   * @throws DataFormatException if a file is missing or wrong
   */
  public static Optional<String> unchanged(String word) throws DataFormatException {
    Optional<String> diagnosed = DiagnosedFolder.in(word);
    if (diagnosed.isEmpty() || DiagnosedMotion.changes(Path.of(diagnosed.get()))) {
      return Optional.empty();
    }
    return Optional.of(
        "the diagnosis in "
            + diagnosed.get()
            + " found nothing that moves the robot otherwise: it drives as believed, and nothing is"
            + " applied");
  }

  /**
   * Reads a robot as a diagnosis found it, which is called as the folder is.
   *
   * @param folder that a diagnosis of motion left
   * @throws DataFormatException if a file is missing or wrong
   */
  public static RobotKind diagnosed(Path folder) throws DataFormatException {
    return new RobotKind(name(folder), DiagnosedMotion.read(folder), DiagnosedMotion.reach(folder));
  }

  /**
   * Reads a robot as it is believed to be, which is called as the file is.
   *
   * @param file a robot.json
   * @throws DataFormatException if it is missing or wrong
   */
  public static RobotKind believed(Path file) throws DataFormatException {
    return new RobotKind(name(file).replaceFirst("[.]json$", ""), DiagnosedMotion.believed(file));
  }

  private static String name(Path path) {
    return DiagnosedFolder.name(path).orElse("robot");
  }
}
