package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/** See {@link DetectionRule#ORIGINAL}. */
final class OriginalSensor extends ConeSensor {
  private final double minRangeM;

  OriginalSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene, obstacle -> DetectionRule.ORIGINAL_RANGE_M + obstacle.reachM());
    minRangeM = sensor.minRangeM();
  }

  @Override
  boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
    return obstacle.centreDistanceM(xM, zM) - obstacle.reachM() <= DetectionRule.ORIGINAL_RANGE_M;
  }

  @Override
  double echoM(Audible audible, TransducerPose from) {
    return atLeast(minRangeM, audible.nearestM(cone, from, DetectionRule.ORIGINAL_RANGE_M));
  }
}
