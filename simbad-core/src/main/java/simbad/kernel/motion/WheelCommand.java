package simbad.kernel.motion;

import simbad.sonar.check.Checks;

/**
 * What a plan asks of a robot for one step.
 *
 * @param speedMPerS along the heading, metres per second
 * @param turnRadPerS counter-clockwise, radians per second
 */
public record WheelCommand(double speedMPerS, double turnRadPerS) {
  /** Checks the speeds. */
  public WheelCommand {
    Checks.finite("speedMPerS", speedMPerS);
    Checks.finite("turnRadPerS", turnRadPerS);
  }

  /** To stand still. */
  public static final WheelCommand STOP = new WheelCommand(0, 0);
}
