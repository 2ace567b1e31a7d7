package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/** See {@link DetectionRule#ORIGINAL}. */
final class OriginalSensor extends ConeSensor {
  private final double minRangeM;

  OriginalSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene);
    minRangeM = sensor.minRangeM();
  }

  @Override
  double echoM(PlacedObstacle obstacle, TransducerPose from) {
    return atLeast(minRangeM, obstacle.nearestM(cone, from, DetectionRule.ORIGINAL_RANGE_M));
  }
}
