package simbad.sonar.model;

import java.util.Optional;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.shape.Cone;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.NearestPoints;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** An obstacle with its outline laid out in the world, so that a ping computes nothing twice. */
class PlacedObstacle {
  /** A uniform threshold's circle as a polygon: 0.1 mm inside it at 3 m. */
  private static final int CIRCLE_CORNERS = 360;

  private final Obstacle obstacle;
  private final Outline worldOutline;
  private final double reachM;
  private final double greatestThresholdM;

  PlacedObstacle(Obstacle obstacle) {
    this.obstacle = obstacle;
    worldOutline = obstacle.worldOutline();
    reachM = obstacle.outline().reachM(0, 0);
    greatestThresholdM = obstacle.detection().greatestM();
  }

  /** Returns the shadow's edge in the world, laid out anew; none where there is no shadow. */
  Optional<Outline> shadowEdge() {
    ThresholdTable table =
        obstacle
            .detection()
            .findTable()
            .orElseGet(() -> ThresholdTable.uniform(CIRCLE_CORNERS, detection().greatestM()));
    return new DetectionShadow(table).edge().map(edge -> edge.placed(obstacle.worldFromObstacle()));
  }

  static PlacedObstacle[] all(Scene scene) {
    return scene.obstacles().stream().map(PlacedObstacle::new).toArray(PlacedObstacle[]::new);
  }

  Obstacle obstacle() {
    return obstacle;
  }

  Detection detection() {
    return obstacle.detection();
  }

  double xM() {
    return obstacle.worldFromObstacle().xM();
  }

  double zM() {
    return obstacle.worldFromObstacle().zM();
  }

  /** The greatest distance of its outline from its centre. */
  double reachM() {
    return reachM;
  }

  double greatestThresholdM() {
    return greatestThresholdM;
  }

  double centreDistanceM(double xM, double zM) {
    return obstacle.worldFromObstacle().centreDistanceM(xM, zM);
  }

  double bearingRad(double xM, double zM) {
    return obstacle.worldFromObstacle().bearingRad(xM, zM);
  }

  double outlineDistanceM(double xM, double zM) {
    return worldOutline.distanceM(xM, zM);
  }

  /** The nearest points of the outline, wherever the sensor looks. */
  void findNearest(double xM, double zM, NearestPoints found) {
    worldOutline.findNearest(xM, zM, found);
  }

  /** The nearest point of the outline in the cone; infinity when there is none. */
  double nearestM(Cone cone, TransducerPose from) {
    return cone.misses(from.alongM(xM(), zM()), from.acrossM(xM(), zM()), reachM)
        ? Double.POSITIVE_INFINITY
        : inConeM(cone, from);
  }

  /** The same, for one that is known to be near the cone. */
  double inConeM(Cone cone, TransducerPose from) {
    return cone.nearestM(worldOutline, from.xM, from.zM, from.directionX, from.directionZ);
  }

  /** Whether a place is near enough to hear the obstacle; where the threshold is 0 none is. */
  boolean inShadow(double xM, double zM) {
    double distance = centreDistanceM(xM, zM);
    return distance <= greatestThresholdM && distance <= positiveThresholdM(bearingRad(xM, zM));
  }

  /** The threshold, or less than any distance where it is 0. */
  private double positiveThresholdM(double bearingRad) {
    double threshold = detection().thresholdM(bearingRad);
    return threshold > 0 ? threshold : Double.NEGATIVE_INFINITY;
  }
}
