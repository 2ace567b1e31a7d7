package simbad.cli;

import simbad.experiments.run.RobotKind;
import simbad.sonar.format.DataFormatException;

/** A robot on the command line: a diagnosis' folder, or a file that says what is believed. */
final class RobotArgument {
  /** What help says of it. */
  static final String MEANING =
      "diagnosed:DIR (the folder that simbad diagnose made of a motion folder), or a robot.json";

  private RobotArgument() {}

  /**
   * Reads a robot.
   *
   * @param word of the command line
   * @throws DataFormatException if a file is missing or wrong
   */
  static RobotKind parse(String word) throws DataFormatException {
    return RobotKind.read(word);
  }
}
