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
    return diagnosed.isPresent() ? diagnosed(Path.of(diagnosed.get())) : believed(Path.of(word));
  }

  /**
   * Reads a robot as a diagnosis found it, which is called as the folder is.
   *
   * @param folder that a diagnosis of motion left
   * @throws DataFormatException if a file is missing or wrong
   */
  public static RobotKind diagnosed(Path folder) throws DataFormatException {
    return new RobotKind(name(folder), DiagnosedMotion.read(folder));
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
