package simbad.experiments.export;

import java.util.List;
import java.util.SplittableRandom;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** The one implementation of the rule of detection shadows, before one obstacle. */
final class RuleInMetres {
  private final Sensor rule;
  private final TransducerPoses at = new TransducerPoses(1);
  private final Readings readings = new Readings(1);

  RuleInMetres(ObstacleType type, SonarSpec sensor) {
    this(type, sensor, Placement.IDENTITY);
  }

  RuleInMetres(ObstacleType type, SonarSpec sensor, Placement placement) {
    Obstacle obstacle =
        new Obstacle(
            "post", placement, type.outline(), new TableDetection(type.thresholds().table()));
    rule = DetectionRule.SHADOW.bind(sensor, new Scene(List.of(obstacle)), new SplittableRandom(1));
  }

  /** Metres; below 0 for no echo. */
  double readM(double xM, double zM, double headingRad) {
    at.setPosition(0, xM, 0.15, zM);
    at.setDirection(0, Math.cos(headingRad), 0, -Math.sin(headingRad));
    rule.ping(at, 0, readings);
    return readings.isEcho(0) ? readings.rangeM(0) : -1;
  }

  double readM(int[] pose) {
    return readM(pose[0] / 1000.0, pose[1] / 1000.0, Math.toRadians(pose[2] / 100.0));
  }
}
