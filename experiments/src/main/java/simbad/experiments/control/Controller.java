package simbad.experiments.control;

import simbad.sonar.sensing.Readings;

/** Drives a robot by what its belt reads. May remember what it read and commanded before. */
@FunctionalInterface
public interface Controller {
  /**
   * Decides the next step.
   *
   * @param readings of the belt at the start of the step
   * @param command receives the velocities that hold during the step
   */
  void decide(Readings readings, Command command);
}
