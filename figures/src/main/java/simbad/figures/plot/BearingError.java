package simbad.figures.plot;

import simbad.sonar.check.Checks;

/**
 * The error of a trace at one bearing of the table.
 *
 * @param bearingRad the bearing in radians, shown in [0, 360) degrees; finite
 * @param errorM the mean of |r - T| over the crossings of that bearing, in metres; finite, at least
 *     0
 */
public record BearingError(double bearingRad, double errorM) {
  /** Checks both numbers. */
  public BearingError {
    Checks.finite("bearingRad", bearingRad);
    Checks.notNegative("errorM", errorM);
  }

  /** The bearing in [0, 360) degrees; a billionth short of 360, as conversions leave it, is 0. */
  double bearingDeg() {
    double turns = Math.rint(Math.toDegrees(bearingRad) * 1e9) / 1e9;
    double within = turns % 360;
    return within < 0 ? within + 360 : within + 0.0;
  }
}
