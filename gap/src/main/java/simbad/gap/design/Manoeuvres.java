package simbad.gap.design;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;

/**
 * A library of manoeuvres before the obstacles of a scene, each of at most 75 pings: drives towards
 * an obstacle and back, slow and fast; turns on the spot before it; rounds about it, facing it,
 * looking past it by nearly the cone's half angle, and looking along the path; ladders of distances
 * at which the sensor stands.
 */
final class Manoeuvres {
  /** Two of them make an experiment of 150 pings. */
  static final int PINGS = 75;

  private static final int BEARINGS = 24;
  private static final double SLOW_M_PER_S = 0.1;
  private static final double FAST_M_PER_S = 0.6;
  private static final double CLEARANCE_M = 0.05;
  private static final double BEYOND = 1.25;
  private static final int RUNGS = 15;
  private static final double[] REACHES = {0.3, 0.6, 0.85, 1};

  private final SensingSetup setup;
  private final Obstacle obstacle;
  private final List<Manoeuvre> all = new ArrayList<>();

  private Manoeuvres(SensingSetup setup, Obstacle obstacle) {
    this.setup = setup;
    this.obstacle = obstacle;
  }

  /** Returns the manoeuvres before all obstacles; those that would hit one are left out. */
  static List<Manoeuvre> before(SensingSetup setup) {
    List<Manoeuvre> all = new ArrayList<>();
    for (Obstacle obstacle : setup.scene().obstacles()) {
      all.addAll(new Manoeuvres(setup, obstacle).made());
    }
    return all.stream().filter(manoeuvre -> isFree(manoeuvre, setup)).toList();
  }

  private static boolean isFree(Manoeuvre manoeuvre, SensingSetup setup) {
    return setup.scene().obstacles().stream()
        .allMatch(
            obstacle ->
                manoeuvre.poses().stream()
                    .allMatch(
                        pose ->
                            obstacle
                                    .worldFromObstacle()
                                    .centreDistanceM(pose.position().xM(), pose.position().zM())
                                >= obstacle.outline().reachM(0, 0)));
  }

  private List<Manoeuvre> made() {
    for (int i = 0; i < BEARINGS; i++) {
      double bearing = 2 * Math.PI * i / BEARINGS;
      drive(bearing, SLOW_M_PER_S);
      drive(bearing, FAST_M_PER_S);
      if (i % 3 == 0) {
        ladder(bearing);
        for (double reach : REACHES) {
          turn(bearing, reach);
        }
      }
    }
    double past = 0.9 * setup.sensor().coneHalfAngleRad();
    for (double reach : REACHES) {
      for (double off : new double[] {0, past, -past, Math.PI / 2}) {
        round(reach, off);
      }
    }
    return all;
  }

  private double nearM() {
    return obstacle.outline().reachM(0, 0) + CLEARANCE_M;
  }

  /** Just beyond where it is lost, or where the sensor gives up. */
  private double farM(double bearingRad) {
    double threshold = obstacle.detection().thresholdM(bearingRad);
    double reach = threshold > 0 ? threshold : obstacle.detection().greatestM();
    return Math.max(2 * nearM(), BEYOND * Math.min(reach, setup.sensor().maxRangeM()));
  }

  private Pose pose(double bearingRad, double distanceM, double offRad) {
    Placement place = obstacle.worldFromObstacle();
    double direction = bearingRad + place.turnRad();
    double dx = distanceM * Math.sin(direction);
    double dz = distanceM * Math.cos(direction);
    return Pose.of(place.xM() + dx, place.zM() + dz, Math.atan2(dz, -dx) + offRad);
  }

  private void add(double pathM, double speedMPerS, IntFunction<Pose> pose) {
    double stepS = Math.max(setup.sensor().updatePeriodS(), pathM / (PINGS * speedMPerS));
    all.add(new Manoeuvre(IntStream.range(0, PINGS).mapToObj(pose).toList(), stepS));
  }

  /** In and out again. */
  private void drive(double bearingRad, double speedMPerS) {
    double near = nearM();
    double far = farM(bearingRad);
    add(
        2 * (far - near),
        speedMPerS,
        i -> {
          double out = Math.abs(2.0 * i / (PINGS - 1) - 1);
          return pose(bearingRad, near + out * (far - near), 0);
        });
  }

  private void ladder(double bearingRad) {
    double near = nearM();
    double far = farM(bearingRad);
    int each = PINGS / RUNGS;
    add(
        far - near,
        SLOW_M_PER_S,
        i -> {
          int rung = Math.min(RUNGS - 1, i / each);
          return pose(bearingRad, near + (far - near) * rung / (RUNGS - 1), 0);
        });
  }

  /** From one side of the obstacle to the other, well beyond the cone's edge. */
  private void turn(double bearingRad, double reach) {
    double widest = Math.min(Math.PI, 2.5 * setup.sensor().coneHalfAngleRad());
    double distance = Math.max(nearM(), reach * farM(bearingRad) / BEYOND);
    add(0, 1, i -> pose(bearingRad, distance, widest * (2.0 * i / (PINGS - 1) - 1)));
  }

  private void round(double reach, double offRad) {
    double greatest = Math.min(obstacle.detection().greatestM(), setup.sensor().maxRangeM());
    double distance = Math.max(nearM(), reach * greatest);
    add(2 * Math.PI * distance, FAST_M_PER_S, i -> pose(2 * Math.PI * i / PINGS, distance, offRad));
  }
}
