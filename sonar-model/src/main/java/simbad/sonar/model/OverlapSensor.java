package simbad.sonar.model;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/** See {@link DetectionRule#OVERLAP}. */
final class OverlapSensor extends ConeSensor {
  private final double maxRangeM;
  private final Map<PlacedObstacle, Optional<Outline>> edges = new HashMap<>();

  OverlapSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene, obstacle -> sensor.maxRangeM() + obstacle.greatestThresholdM());
    maxRangeM = sensor.maxRangeM();
  }

  @Override
  boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
    return obstacle.centreDistanceM(xM, zM) <= maxRangeM + obstacle.greatestThresholdM();
  }

  @Override
  double echoM(Audible audible, TransducerPose from) {
    PlacedObstacle obstacle = audible.obstacle();
    // The tip in the shadow, or the shadow's edge in the cone: no other way to overlap.
    return obstacle.inShadow(from.xM, from.zM) || edgeM(obstacle, from) <= maxRangeM
        ? audible.distanceM()
        : Double.POSITIVE_INFINITY;
  }

  /**
   * The nearest point of the shadow's edge in the cone; infinity without one, or without shadow.
   */
  private double edgeM(PlacedObstacle obstacle, TransducerPose from) {
    Optional<Outline> edge = edges.computeIfAbsent(obstacle, PlacedObstacle::shadowEdge);
    return edge.isPresent()
        ? cone.nearestM(edge.get(), from.xM, from.zM, from.directionX, from.directionZ)
        : Double.POSITIVE_INFINITY;
  }
}
