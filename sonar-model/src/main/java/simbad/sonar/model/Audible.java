package simbad.sonar.model;

import simbad.sonar.shape.Cone;

/**
 * An obstacle that may be heard at one place. What does not depend on where the sensor looks is
 * computed once for all transducers that sit there. A mutable buffer, refilled from place to place.
 */
final class Audible {
  private PlacedObstacle obstacle;
  private double fromXM;
  private double fromZM;
  private boolean measured;
  private double distanceM;

  Audible(PlacedObstacle obstacle) {
    this.obstacle = obstacle;
  }

  /** Becomes another obstacle, another place, or both. */
  void set(PlacedObstacle newObstacle, double xM, double zM) {
    obstacle = newObstacle;
    fromXM = xM;
    fromZM = zM;
    measured = false;
  }

  PlacedObstacle obstacle() {
    return obstacle;
  }

  /** The nearest point of the outline, wherever the sensor looks. */
  double distanceM() {
    if (!measured) {
      distanceM = obstacle.outlineDistanceM(fromXM, fromZM);
      measured = true;
    }
    return distanceM;
  }

  /** The nearest point of the outline in the cone, infinity when there is none within a limit. */
  double nearestM(Cone cone, TransducerPose from, double limitM) {
    double along = from.alongM(obstacle.xM(), obstacle.zM());
    double across = from.acrossM(obstacle.xM(), obstacle.zM());
    if (cone.misses(along, across, obstacle.reachM())) {
      return Double.POSITIVE_INFINITY;
    }
    double nearest =
        cone.holds(along, across, obstacle.reachM()) ? distanceM() : obstacle.inConeM(cone, from);
    return nearest <= limitM ? nearest : Double.POSITIVE_INFINITY;
  }
}
