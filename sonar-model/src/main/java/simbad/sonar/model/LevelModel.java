package simbad.sonar.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.level.Decibels;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.TargetStrength;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.NearestPoints;

/**
 * The level model: what a simulator expects of a ping when echoes have strength.
 *
 * <p>An obstacle's echo exceeds the receiver's threshold by so many decibels as the {@link
 * LevelLaw} says; it is heard with probability (1 - missRate) Phi(excess / sd) if the nearest point
 * of its outline, wherever the sensor looks, is between the minimum and maximum range. It reads
 * that point's distance plus the walk of its excess. Of several the first that crosses the
 * threshold is read, and echoes that overlap add their energies. See docs/method/level-model.md.
 * Immutable, safe for use by several threads.
 */
public final class LevelModel {
  private final SonarSpec sensor;
  private final LevelLaw law;
  private final LevelTarget[] targets;
  private final EarshotTree earshots;

  /**
   * Binds a sensor to a scene. Thresholds of the scene are taken as measured under the law that the
   * sensor's figures state.
   *
   * @param sensor the sensor's figures
   * @param scene the obstacles
   */
  public LevelModel(SonarSpec sensor, Scene scene) {
    this(sensor, scene, sensor.levelLaw());
  }

  private LevelModel(SonarSpec sensor, Scene scene, LevelLaw believed) {
    this(
        sensor,
        believed,
        scene.obstacles(),
        scene.obstacles().stream()
            .map(obstacle -> LevelTarget.strength(obstacle.detection(), believed))
            .toList());
  }

  /**
   * Binds a sensor to obstacles of known strength.
   *
   * @param sensor its range, misses and resolution count here
   * @param law by which it hears
   * @param obstacles their thresholds do not count here
   * @param strengths of the obstacles, in the same order
   */
  public LevelModel(
      SonarSpec sensor, LevelLaw law, List<Obstacle> obstacles, List<TargetStrength> strengths) {
    this(
        sensor,
        law,
        IntStream.range(0, obstacles.size())
            .mapToObj(i -> new LevelTarget(obstacles.get(i), strengths.get(i), law))
            .toArray(LevelTarget[]::new));
  }

  private LevelModel(SonarSpec sensor, LevelLaw law, LevelTarget[] targets) {
    this.sensor = sensor;
    this.law = law;
    this.targets = targets;
    earshots =
        new EarshotTree(
            targets,
            Arrays.stream(targets)
                .mapToDouble(target -> sensor.maxRangeM() + target.reachM())
                .toArray());
  }

  /**
   * Returns the same targets, of the same strengths, heard under another law: what a change of the
   * sensor or of the air does.
   *
   * @param actual by which the sensor really hears
   */
  public LevelModel heardBy(LevelLaw actual) {
    return new LevelModel(
        sensor,
        actual,
        Arrays.stream(targets).map(target -> target.heardBy(actual)).toArray(LevelTarget[]::new));
  }

  /** Returns the law by which the sensor hears. */
  public LevelLaw law() {
    return law;
  }

  /** Returns the number of obstacles. */
  public int size() {
    return targets.length;
  }

  SonarSpec sensor() {
    return sensor;
  }

  LevelTarget[] targets() {
    return targets;
  }

  /**
   * Returns what the model makes of one obstacle, were it alone.
   *
   * @param obstacle index in the scene, from 0
   * @param pose of the sensor
   */
  public LevelSight sight(int obstacle, Pose pose) {
    double xM = pose.position().xM();
    double zM = pose.position().zM();
    TransducerPose from = new TransducerPose().aim(xM, zM, pose.heading().radians());
    LevelTarget target = targets[obstacle];
    NearestPoints nearest = new NearestPoints();
    target.findNearest(xM, zM, nearest);
    double centre = target.centreDistanceM(xM, zM);
    double energy = target.axisEnergy(law, xM, zM, centre) * beamEnergy(law, nearest, from);
    double bearing = target.bearingRad(xM, zM);
    double excess = Decibels.level(energy);
    return new LevelSight(
        centre,
        bearing,
        target.strength().strengthDb(bearing),
        nearest.distanceM(),
        Math.min(
            offAxisRad(from, nearest.xM(), nearest.zM()),
            offAxisRad(from, nearest.otherXM(), nearest.otherZM())),
        excess,
        isInRange(nearest.distanceM())
            ? Crossings.chance(excess, law.excessSdDb(), sensor.missRate())
            : 0);
  }

  private static double offAxisRad(TransducerPose from, double xM, double zM) {
    return Math.abs(Math.atan2(from.acrossM(xM, zM), from.alongM(xM, zM)));
  }

  /** What the beam leaves of an echo from the nearest point; of two from that nearer the axis. */
  static double beamEnergy(LevelLaw law, NearestPoints nearest, TransducerPose from) {
    double along = from.alongM(nearest.xM(), nearest.zM());
    double otherAlong = from.alongM(nearest.otherXM(), nearest.otherZM());
    if (along >= otherAlong) {
      return law.beam().twoWayEnergy(along, from.acrossM(nearest.xM(), nearest.zM()));
    }
    // A sensor that looks straight up has no axis on the plane: then no comparison holds.
    return along < otherAlong
        ? law.beam().twoWayEnergy(otherAlong, from.acrossM(nearest.otherXM(), nearest.otherZM()))
        : 0;
  }

  private boolean isInRange(double distanceM) {
    return distanceM >= sensor.minRangeM() && distanceM <= sensor.maxRangeM();
  }

  /**
   * Returns the distribution of the reading at a pose.
   *
   * @param pose of the sensor
   */
  public ReadingDistribution distribution(Pose pose) {
    Crossings crossings = new Crossings(law, sensor.missRate());
    TransducerPose from =
        new TransducerPose()
            .aim(pose.position().xM(), pose.position().zM(), pose.heading().radians());
    NearestPoints nearest = new NearestPoints();
    for (int i : withinRange(pose.position())) {
      LevelTarget target = targets[i];
      target.findNearest(from.xM, from.zM, nearest);
      double centre = target.centreDistanceM(from.xM, from.zM);
      double energy =
          target.axisEnergy(law, from.xM, from.zM, centre) * beamEnergy(law, nearest, from);
      if (energy > 0 && isInRange(nearest.distanceM())) {
        crossings.add(nearest.distanceM(), energy);
      }
    }
    crossings.settle();
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < crossings.size(); i++) {
      if (crossings.share(i) > 0) {
        parts.add(new Part(crossings.meanM(i), crossings.deviationM(i), 0, crossings.share(i)));
      }
    }
    return new ReadingDistribution(parts, sensor.resolutionM(), Report.AS_MEASURED);
  }

  /** In the scene's order: equal ranges keep it. */
  private int[] withinRange(Point place) {
    IntStream.Builder found = IntStream.builder();
    earshots.find(place.xM(), place.zM(), 0, found::add);
    return found.build().sorted().toArray();
  }
}
