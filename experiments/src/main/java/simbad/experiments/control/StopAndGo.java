package simbad.experiments.control;

import simbad.sonar.sensing.Readings;

/**
 * Lets another controller decide, and gives the robot the time that it needs to do it: a fast turn
 * becomes a slower one on the spot, and then the robot stands still until it has done what it was
 * told. A robot that turns slowly, acts late and slows down gradually is then where the other
 * controller believes it to be when it reads again.
 */
public final class StopAndGo implements Controller {
  private final Controller other;
  private final int waitSteps;
  private final double mostRadPerS;
  private int turnsLeft;
  private double turnRadPerS;
  private int waitsLeft;

  /**
   * Creates a controller that decides in its first step.
   *
   * @param other decides
   * @param waitSteps for so many steps the robot is told to stand still after each decision; at
   *     least 0
   * @param mostRadPerS how fast it is told to turn at most, positive
   */
  public StopAndGo(Controller other, int waitSteps, double mostRadPerS) {
    if (waitSteps < 0) {
      throw new IllegalArgumentException("waitSteps = " + waitSteps + " is not at least 0");
    }
    this.other = other;
    this.waitSteps = waitSteps;
    if (!(mostRadPerS > 0 && mostRadPerS < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("mostRadPerS = " + mostRadPerS + " is not positive");
    }
    this.mostRadPerS = mostRadPerS;
  }

  @Override
  public void decide(Readings readings, Command command) {
    if (turnsLeft > 0) {
      turnsLeft--;
      command.set(0, turnRadPerS);
    } else if (waitsLeft > 0) {
      waitsLeft--;
      command.set(0, 0);
    } else {
      other.decide(readings, command);
      waitsLeft = waitSteps;
      turnOnTheSpot(command);
    }
  }

  /** A step goes straight and turns afterwards, so this leads to the same place. */
  private void turnOnTheSpot(Command command) {
    int steps = (int) Math.ceil(Math.abs(command.turnRateRadPerS()) / mostRadPerS);
    if (steps > 1) {
      turnsLeft = steps;
      turnRadPerS = command.turnRateRadPerS() / steps;
      command.set(command.speedMPerS(), 0);
    }
  }
}
