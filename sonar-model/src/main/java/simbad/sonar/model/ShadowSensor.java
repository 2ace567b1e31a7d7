package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/** See {@link DetectionRule#SHADOW}. */
final class ShadowSensor extends ConeSensor {
  private final double minRangeM;
  private final double maxRangeM;

  ShadowSensor(SonarSpec sensor, Scene scene) {
    super(sensor, scene);
    minRangeM = sensor.minRangeM();
    maxRangeM = sensor.maxRangeM();
  }

  @Override
  double echoM(PlacedObstacle obstacle, TransducerPose from) {
    return obstacle.inShadow(from.xM, from.zM)
        ? atLeast(minRangeM, obstacle.nearestM(cone, from, maxRangeM))
        : Double.POSITIVE_INFINITY;
  }
}
