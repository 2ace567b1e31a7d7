package simbad.motion.forecast;

import simbad.motion.Displacement;
import simbad.sonar.check.Checks;

/**
 * A stretch of a run at whose ends the track is known.
 *
 * @param run index of the run
 * @param startS when it begins
 * @param horizonS how long it is
 * @param headingRad of the pose at its start
 * @param xM of that pose
 * @param yM of that pose
 * @param way what the tracker saw
 */
public record Window(
    int run,
    double startS,
    double horizonS,
    double headingRad,
    double xM,
    double yM,
    Displacement way) {
  /** Checks the figures. */
  public Window {
    Checks.finite("startS", startS);
    Checks.positive("horizonS", horizonS);
    Checks.finite("headingRad", headingRad);
    Checks.finite("xM", xM);
    Checks.finite("yM", yM);
  }

  /** Returns when it ends. */
  public double endS() {
    return startS + horizonS;
  }
}
