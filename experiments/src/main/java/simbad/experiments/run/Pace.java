package simbad.experiments.run;

import simbad.experiments.control.Controller;
import simbad.experiments.control.StopAndGo;
import simbad.experiments.control.Tuning;
import simbad.sonar.check.Checks;

/**
 * How much time a robot is given for what its controller decides.
 *
 * @param turnRateRadPerS how fast the robot is told to turn at most; what the controller wants to
 *     turn faster takes several steps on the spot
 * @param waitS how long the robot stands still after each decision, seconds, at least 0
 */
public record Pace(double turnRateRadPerS, double waitS) {
  /** Each decision takes one step. */
  public static final Pace AT_ONCE = new Pace(Tuning.TURN_RATE, 0);

  /** A robot that turns more slowly takes an hour to turn back. */
  public static final double LEAST_TURN_RATE_RAD_PER_S = 0.001;

  /** A robot that waits longer takes a day round an obstacle. */
  public static final double MOST_WAIT_S = 5;

  /** Checks the numbers. */
  public Pace {
    Checks.within("turnRateRadPerS", turnRateRadPerS, LEAST_TURN_RATE_RAD_PER_S, Tuning.TURN_RATE);
    Checks.within("waitS", waitS, 0, MOST_WAIT_S);
  }

  /** Returns a controller that gives the robot its time. */
  public Controller of(Controller controller) {
    return isAtOnce() ? controller : new StopAndGo(controller, waitSteps(), turnRateRadPerS);
  }

  /** Returns the most steps that a decision takes. */
  int mostSteps() {
    return isAtOnce() ? 1 : 1 + waitSteps() + (int) Math.ceil(Tuning.TURN_RATE / turnRateRadPerS);
  }

  private boolean isAtOnce() {
    return waitSteps() == 0 && turnRateRadPerS == Tuning.TURN_RATE;
  }

  private int waitSteps() {
    return (int) Math.round(waitS / Circuit.STEP_S);
  }
}
