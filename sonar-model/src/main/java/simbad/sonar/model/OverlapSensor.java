package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/** See {@link DetectionRule#OVERLAP}. */
final class OverlapSensor extends ConeSensor {
  private final double maxRangeM;

  OverlapSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene);
    maxRangeM = sensor.maxRangeM();
  }

  @Override
  double echoM(PlacedObstacle obstacle, TransducerPose from) {
    // The tip in the shadow, or the shadow's edge in the cone: no other way to overlap.
    return obstacle.inShadow(from.xM, from.zM) || obstacle.shadowEdgeM(cone, from) <= maxRangeM
        ? obstacle.outlineDistanceM(from.xM, from.zM)
        : Double.POSITIVE_INFINITY;
  }
}
