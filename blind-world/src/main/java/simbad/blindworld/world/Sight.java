package simbad.blindworld.world;

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

  /** True when some of the obstacle is in the cone. */
  public boolean inCone() {
    return distanceM < Double.POSITIVE_INFINITY;
  }
}
