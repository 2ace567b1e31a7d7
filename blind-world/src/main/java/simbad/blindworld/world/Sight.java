package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * One obstacle as one ping has it before it.
 *
 * @param body the obstacle's index in the world
 * @param centreM the distance to the obstacle's centre, r
 * @param bearingRad the bearing of the transducer in the obstacle's own frame
 * @param distanceM the distance to the nearest point in the cone, infinite when none is in it
 * @param offAxisRad that point's angle beside the axis, counter-clockwise
 * @param thresholdM the threshold at the bearing
 */
public record Sight(
    int body,
    double centreM,
    double bearingRad,
    double distanceM,
    double offAxisRad,
    double thresholdM) {
  /** Refuses what is no such thing. */
  public Sight {
    Checks.notNegative("distance of the centre", centreM);
    Checks.finite("bearing", bearingRad);
    Checks.number("distance", distanceM);
    Checks.finite("angle off the axis", offAxisRad);
    Checks.notNegative("threshold", thresholdM);
  }

  /** True when some of the obstacle is in the cone. */
  public boolean inCone() {
    return distanceM < Double.POSITIVE_INFINITY;
  }
}
