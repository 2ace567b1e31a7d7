package simbad.sonar.model;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.Cone;

/** A noise-free sensor: each transducer reads the nearest obstacle that answers. */
abstract class ConeSensor implements Sensor {
  final Cone cone;
  private final PlacedObstacle[] obstacles;
  private final TransducerPose pose = new TransducerPose();

  ConeSensor(SonarSpec sensor, Scene scene) {
    cone = new Cone(sensor.coneHalfAngleRad());
    obstacles = PlacedObstacle.all(scene);
  }

  /** The range of an obstacle's echo in metres, infinity when it does not answer. */
  abstract double echoM(PlacedObstacle obstacle, TransducerPose from);

  @Override
  public final void ping(TransducerPoses poses, double timeS, Readings readings) {
    for (int i = 0; i < poses.size(); i++) {
      pose.take(poses, i);
      double nearest = Double.POSITIVE_INFINITY;
      for (PlacedObstacle obstacle : obstacles) {
        nearest = Math.min(nearest, echoM(obstacle, pose));
      }
      if (nearest < Double.POSITIVE_INFINITY) {
        readings.setEcho(i, nearest);
      } else {
        readings.setNoEcho(i);
      }
    }
  }

  static double atLeast(double leastM, double distanceM) {
    return distanceM >= leastM ? distanceM : Double.POSITIVE_INFINITY;
  }
}
