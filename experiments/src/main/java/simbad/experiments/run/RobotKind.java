package simbad.experiments.run;

import simbad.motion.MotionChain;

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
}
