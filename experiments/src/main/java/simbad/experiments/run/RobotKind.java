package simbad.experiments.run;

import java.nio.file.Path;
import java.util.Optional;
import simbad.motion.MotionChain;
import simbad.motion.format.DiagnosedMotion;
import simbad.sonar.format.DataFormatException;

/**
 * A robot that does not do exactly what it is told.
 *
 * @param name in files and tables; what cannot stand in a file's name becomes a hyphen
 * @param motion how it moves
 */
public record RobotKind(String name, MotionChain motion) {
  /** Makes the name one of a file. */
  public RobotKind {
    name = name.replaceAll("[^A-Za-z0-9_.-]", "-");
    if (name.isEmpty()) {
      throw new IllegalArgumentException("a robot needs a name");
    }
  }

  /**
   * Reads a robot of the command line.
   *
   * @param word "diagnosed:" and the folder that a diagnosis of motion left, or a robot.json
   * @throws DataFormatException if a file is missing or wrong
   */
  public static RobotKind read(String word) throws DataFormatException {
    Optional<String> diagnosed = DiagnosedFolder.in(word);
    if (diagnosed.isPresent()) {
      Path folder = Path.of(diagnosed.get());
      return new RobotKind(name(folder), DiagnosedMotion.read(folder));
    }
    Path file = Path.of(word);
    return new RobotKind(name(file).replaceFirst("[.]json$", ""), DiagnosedMotion.believed(file));
  }

  private static String name(Path path) {
    return DiagnosedFolder.name(path).orElse("robot");
  }
}
