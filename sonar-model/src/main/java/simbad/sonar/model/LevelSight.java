package simbad.sonar.model;

import simbad.sonar.check.Checks;

/**
 * What the level model makes of one obstacle from one pose, were it alone.
 *
 * @param centreDistanceM from the sensor to the obstacle's centre, metres
 * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
 * @param strengthDb of the target at that bearing; negative infinity where it never answers
 * @param nearestM distance to the nearest point of the outline, metres
 * @param offAxisRad of that point to either side of the heading, in [0, pi]; of two points equally
 *     near that of the one nearer the axis
 * @param excessDb of its echo over the receiver's threshold; negative infinity where nothing comes
 * @param echoProbability that it answers a ping, in [0, 1]; 0 outside the sensor's range
 */
public record LevelSight(
    double centreDistanceM,
    double bearingRad,
    double strengthDb,
    double nearestM,
    double offAxisRad,
    double excessDb,
    double echoProbability) {
  /** Refuses what is no number. */
  public LevelSight {
    Checks.number("centreDistanceM", centreDistanceM);
    Checks.number("bearingRad", bearingRad);
    Checks.number("strengthDb", strengthDb);
    Checks.number("nearestM", nearestM);
    Checks.number("offAxisRad", offAxisRad);
    Checks.number("excessDb", excessDb);
    Checks.share("echoProbability", echoProbability);
  }
}
