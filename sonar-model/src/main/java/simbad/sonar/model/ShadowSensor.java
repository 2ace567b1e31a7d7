package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/** See {@link DetectionRule#SHADOW}. */
final class ShadowSensor extends ConeSensor {
  private final double minRangeM;
  private final double maxRangeM;

  ShadowSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene, PlacedObstacle::greatestThresholdM);
    minRangeM = sensor.minRangeM();
    maxRangeM = sensor.maxRangeM();
  }

  @Override
  boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
    return obstacle.inShadow(xM, zM);
  }

  @Override
  double echoM(Audible audible, TransducerPose from) {
    return atLeast(minRangeM, audible.nearestM(cone, from, maxRangeM));
  }
}
