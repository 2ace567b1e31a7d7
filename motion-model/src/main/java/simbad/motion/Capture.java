package simbad.motion;

import simbad.sonar.check.Checks;

/**
 * What a tracker reports of a robot.
 *
 * @param forwardM of the tracked point before the robot's centre
 * @param leftM of it to the left
 * @param headingRad by which the tracker's heading is turned
 */
public record Capture(double forwardM, double leftM, double headingRad) {
  /** Checks the figures. */
  public Capture {
    Checks.finite("forwardM", forwardM);
    Checks.finite("leftM", leftM);
    Checks.finite("headingRad", headingRad);
  }

  /** The centre and the heading itself. */
  public static final Capture CENTRE = new Capture(0, 0, 0);

  /**
   * Returns the displacement that a tracker reports.
   *
   * @param robot how the robot's centre moved, in its own frame
   */
  public Displacement of(Displacement robot) {
    if (forwardM == 0 && leftM == 0 && headingRad == 0) {
      return robot;
    }
    double cos = Math.cos(robot.turnRad());
    double sin = Math.sin(robot.turnRad());
    double along = robot.alongM() + forwardM * (cos - 1) - leftM * sin;
    double across = robot.acrossM() + forwardM * sin + leftM * (cos - 1);
    double cosine = Math.cos(headingRad);
    double sine = Math.sin(headingRad);
    return new Displacement(
        along * cosine + across * sine, across * cosine - along * sine, robot.turnRad());
  }
}
