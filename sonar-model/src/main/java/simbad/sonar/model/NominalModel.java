package simbad.sonar.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Cone;

/**
 * The nominal model: what a simulator expects of a ping.
 *
 * <p>An obstacle in the cone echoes with probability (1 - missRate) / (1 + exp((r - T(b)) /
 * edgeWidthM)), r being the distance to its centre and T(b) its threshold, provided that the
 * nearest point of its outline in the cone is between the minimum and maximum range. Obstacles echo
 * independently; the nearest echo is read. Immutable, safe for use by several threads.
 */
public final class NominalModel {
  private final SonarSpec sensor;
  private final Cone cone;
  private final PlacedObstacle[] obstacles;
  private final EarshotTree earshots;

  /**
   * Binds a sensor to a scene.
   *
   * @param sensor the sensor's figures
   * @param scene the obstacles
   */
  public NominalModel(SonarSpec sensor, Scene scene) {
    this.sensor = sensor;
    cone = new Cone(sensor.coneHalfAngleRad());
    obstacles = PlacedObstacle.all(scene);
    earshots =
        new EarshotTree(
            obstacles,
            Arrays.stream(obstacles)
                .mapToDouble(obstacle -> sensor.maxRangeM() + obstacle.reachM())
                .toArray());
  }

  /** Returns the number of obstacles. */
  public int size() {
    return obstacles.length;
  }

  /**
   * Returns what the model makes of one obstacle.
   *
   * @param obstacle index in the scene, from 0
   * @param pose of the sensor
   */
  public Sight sight(int obstacle, Pose pose) {
    double xM = pose.position().xM();
    double zM = pose.position().zM();
    TransducerPose from = new TransducerPose().aim(xM, zM, pose.heading().radians());
    PlacedObstacle placed = obstacles[obstacle];
    double nearest = placed.nearestM(cone, from);
    double distance = placed.centreDistanceM(xM, zM);
    double bearing = placed.bearingRad(xM, zM);
    double threshold = placed.detection().thresholdM(bearing);
    return new Sight(
        distance,
        bearing,
        threshold,
        nearest < Double.POSITIVE_INFINITY ? OptionalDouble.of(nearest) : OptionalDouble.empty(),
        echoProbability(nearest, distance, threshold));
  }

  /**
   * Traces the geometry of one obstacle without making garbage; bearing and threshold are 0 where
   * no point of the obstacle is in the cone.
   *
   * @param obstacle index in the scene, from 0
   * @param from where the sensor is and looks
   * @param into takes the result
   */
  public void trace(int obstacle, TransducerPose from, SightLine into) {
    PlacedObstacle placed = obstacles[obstacle];
    double nearest = placed.nearestM(cone, from);
    double distance = placed.centreDistanceM(from.xM, from.zM);
    if (nearest == Double.POSITIVE_INFINITY) {
      into.set(nearest, distance, 0, 0);
      return;
    }
    double bearing = placed.bearingRad(from.xM, from.zM);
    into.set(nearest, distance, bearing, placed.detection().thresholdM(bearing));
  }

  /**
   * Returns the distance to the nearest point of an obstacle in the cone, metres; infinity when
   * there is none.
   *
   * @param obstacle index in the scene, from 0
   * @param from where the sensor is and looks
   */
  public double nearestM(int obstacle, TransducerPose from) {
    return obstacles[obstacle].nearestM(cone, from);
  }

  /**
   * Returns the distribution of the reading at a pose.
   *
   * @param pose of the sensor
   */
  public ReadingDistribution distribution(Pose pose) {
    List<Sight> heard = new ArrayList<>();
    for (int i : withinRange(pose.position())) {
      Sight sight = sight(i, pose);
      if (sight.echoProbability() > 0) {
        heard.add(sight);
      }
    }
    heard.sort(Comparator.comparingDouble(sight -> sight.nearestM().orElseThrow()));
    return ReadingDistribution.nearestFirst(heard, sensor.rangeNoiseM(), sensor.resolutionM());
  }

  /** In the scene's order: equal ranges keep it when they are sorted. */
  private int[] withinRange(Point place) {
    IntStream.Builder found = IntStream.builder();
    earshots.find(place.xM(), place.zM(), 0, found::add);
    return found.build().sorted().toArray();
  }

  /**
   * Returns the probability that an obstacle answers.
   *
   * @param nearestM its nearest point in the cone, metres; infinity for none
   * @param centreDistanceM of the sensor from its centre, metres
   * @param thresholdM at the sensor's bearing, metres
   * @return in [0, 1]
   */
  public double echoProbability(double nearestM, double centreDistanceM, double thresholdM) {
    if (!(nearestM >= sensor.minRangeM() && nearestM <= sensor.maxRangeM()) || thresholdM <= 0) {
      return 0;
    }
    double beyondM = centreDistanceM - thresholdM;
    double edge =
        sensor.edgeWidthM() > 0
            ? 1 / (1 + Math.exp(beyondM / sensor.edgeWidthM()))
            : beyondM <= 0 ? 1 : 0;
    return (1 - sensor.missRate()) * edge;
  }
}
