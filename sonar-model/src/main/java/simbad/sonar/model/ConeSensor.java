package simbad.sonar.model;

import java.util.Arrays;
import java.util.function.ToDoubleFunction;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.Cone;

/** A noise-free sensor: each transducer reads the nearest obstacle that answers. */
abstract class ConeSensor implements Sensor {
  final Cone cone;
  private final Earshot<PlacedObstacle> earshot;
  private final TransducerPose pose = new TransducerPose();
  private Audible[] audible = {};
  private int audibleCount;
  private boolean sifted;
  private double siftedXM;
  private double siftedZM;

  /**
   * Binds a sensor to a scene.
   *
   * @param sensor the sensor's figures
   * @param scene the obstacles
   * @param earshotM how far from its centre an obstacle may be heard at most, metres
   */
  ConeSensor(SonarSpec sensor, Scene scene, ToDoubleFunction<PlacedObstacle> earshotM) {
    cone = new Cone(sensor.coneHalfAngleRad());
    PlacedObstacle[] obstacles = PlacedObstacle.all(scene);
    earshot = new Earshot<>(obstacles, Arrays.stream(obstacles).mapToDouble(earshotM).toArray());
  }

  /** Whether an obstacle may answer at a place at all, wherever the sensor looks. */
  abstract boolean isAudible(PlacedObstacle obstacle, double xM, double zM);

  /** The range of an audible obstacle's echo in metres, infinity when it does not answer. */
  abstract double echoM(Audible audible, TransducerPose from);

  @Override
  public final void ping(TransducerPoses poses, double timeS, Readings readings) {
    for (int i = 0; i < poses.size(); i++) {
      pose.take(poses, i);
      sift(pose.xM, pose.zM);
      double nearest = Double.POSITIVE_INFINITY;
      for (int j = 0; j < audibleCount; j++) {
        nearest = Math.min(nearest, echoM(audible[j], pose));
      }
      if (nearest < Double.POSITIVE_INFINITY) {
        readings.setEcho(i, nearest);
      } else {
        readings.setNoEcho(i);
      }
    }
  }

  /** Finds what is audible at a place: once for all transducers that sit at one point. */
  private void sift(double xM, double zM) {
    if (sifted && xM == siftedXM && zM == siftedZM) {
      return;
    }
    earshot.moveTo(xM, zM);
    audibleCount = 0;
    for (int i = 0; i < earshot.size(); i++) {
      PlacedObstacle obstacle = earshot.get(i);
      if (isAudible(obstacle, xM, zM)) {
        next(obstacle).set(obstacle, xM, zM);
      }
    }
    siftedXM = xM;
    siftedZM = zM;
    sifted = true;
  }

  private Audible next(PlacedObstacle obstacle) {
    if (audibleCount == audible.length) {
      audible = Arrays.copyOf(audible, audibleCount + 1);
      audible[audibleCount] = new Audible(obstacle);
    }
    return audible[audibleCount++];
  }

  static double atLeast(double leastM, double distanceM) {
    return distanceM >= leastM ? distanceM : Double.POSITIVE_INFINITY;
  }

  /**
   * An obstacle that may be heard at one place. What does not depend on where the sensor looks is
   * computed once for all transducers that sit there. A mutable buffer, refilled from place to
   * place.
   */
  static final class Audible {
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
}
