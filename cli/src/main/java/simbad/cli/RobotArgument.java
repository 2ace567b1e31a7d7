package simbad.cli;

import java.nio.file.Path;
import simbad.experiments.run.RobotKind;
import simbad.motion.format.DiagnosedMotion;
import simbad.sonar.format.DataFormatException;

/** A robot on the command line: a diagnosis' folder, or a file that says what is believed. */
final class RobotArgument {
  /** What help says of it. */
  static final String MEANING =
      "diagnosed:DIR (the folder that simbad diagnose made of a motion folder), or a robot.json";

  private static final String DIAGNOSED = "diagnosed:";

  private RobotArgument() {}

  /**
   * Reads a robot.
   *
   * @param word of the command line
   * @throws DataFormatException if a file is missing or wrong
   */
  static RobotKind parse(String word) throws DataFormatException {
    if (word.startsWith(DIAGNOSED)) {
      Path folder = Path.of(word.substring(DIAGNOSED.length()));
      return new RobotKind(name(folder), DiagnosedMotion.read(folder));
    }
    Path file = Path.of(word);
    return new RobotKind(name(file).replaceFirst("[.]json$", ""), DiagnosedMotion.believed(file));
  }

  private static String name(Path path) {
    Path last = path.toAbsolutePath().normalize().getFileName();
    return last == null ? "robot" : last.toString();
  }
}
