package simbad.experiments.control;

import simbad.sonar.sensing.Readings;

/**
 * Lets another controller decide, then stands still until the robot has done it: a robot that acts
 * late and slows down gradually is then where the other one believes it to be when it reads again.
 */
public final class StopAndGo implements Controller {
  private final Controller other;
  private final int waitSteps;
  private int waited;

  /**
   * Creates a controller that decides in its first step.
   *
   * @param other decides
   * @param waitSteps for so many steps the robot is told to stand still after each decision; at
   *     least 0
   */
  public StopAndGo(Controller other, int waitSteps) {
    if (waitSteps < 0) {
      throw new IllegalArgumentException("waitSteps = " + waitSteps + " is not at least 0");
    }
    this.other = other;
    this.waitSteps = waitSteps;
    waited = waitSteps;
  }

  @Override
  public void decide(Readings readings, Command command) {
    if (waited < waitSteps) {
      waited++;
      command.set(0, 0);
    } else {
      waited = 0;
      other.decide(readings, command);
    }
  }
}
