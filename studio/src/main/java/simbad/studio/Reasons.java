package simbad.studio;

import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Cone;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.Outline;

/**
 * Why a sonar hears nothing, as the rule of its sensor has it. A fitted model's silence is
 * explained by the law that its sensor's figures state, the level law or the threshold rule; under
 * the latter its effects are not told apart.
 */
final class Reasons {
  /** Numbers on the page's side. */
  static final int HEARD = 0;

  static final int NOTHING_IN_CONE = 1;
  static final int OUTSIDE_SHADOW = 2;
  static final int MISSED = 3;
  static final int OUT_OF_RANGE = 4;
  static final int RAY_PASSES = 5;
  static final int CONE_APART = 6;

  /** Too weak: by so many tenths of a decibel more than this number. */
  static final int TOO_WEAK = 100;

  private static final int WEAKEST_DB = 99;

  /** So thin that it is a ray: a micrometre wide at the farthest place. */
  private static final Cone RAY = new Cone(1e-8);

  private final SensorKind sensor;
  private final SonarSpec spec;
  private final ObstacleType type;
  private final Cone cone;
  private final DetectionShadow shadow;
  private Placement placement = Placement.IDENTITY;
  private Outline outline;
  private Optional<Loudness> loudness;

  Reasons(SensorKind sensor, SonarSpec spec, ObstacleType type) {
    this.sensor = sensor;
    this.spec = spec;
    this.type = type;
    cone = new Cone(spec.coneHalfAngleRad());
    shadow = new DetectionShadow(type.thresholds().table());
    outline = type.outline();
    loudness = Loudness.of(sensor, spec, type, placement);
  }

  /** The obstacle is there from now on. */
  void obstacleAt(Placement worldFromObstacle) {
    if (worldFromObstacle.equals(placement)) {
      return;
    }
    placement = worldFromObstacle;
    outline = type.outline().placed(worldFromObstacle);
    loudness = Loudness.of(sensor, spec, type, placement);
  }

  /**
   * Returns the number of the reason.
   *
   * @param pose of a sonar that heard nothing
   */
  int of(Pose pose) {
    if (loudness.isPresent()) {
      return byLevel(loudness.get().at(pose));
    }
    double nearestM = nearestM(sensor.equals(SensorKind.RAY) ? RAY : cone, outline, pose);
    if (sensor.equals(SensorKind.RAY)) {
      return nearestM == Double.POSITIVE_INFINITY ? RAY_PASSES : OUT_OF_RANGE;
    }
    if (nearestM == Double.POSITIVE_INFINITY) {
      return NOTHING_IN_CONE;
    }
    if (sensor.equals(SensorKind.ORIGINAL)) {
      return missed(nearestM, DetectionRule.ORIGINAL_RANGE_M);
    }
    if (sensor.equals(SensorKind.OVERLAP)) {
      return meetsShadow(pose) ? missed(nearestM, Double.POSITIVE_INFINITY) : CONE_APART;
    }
    return inShadow(pose) ? missed(nearestM, spec.maxRangeM()) : OUTSIDE_SHADOW;
  }

  private int missed(double nearestM, double mostM) {
    return nearestM < spec.minRangeM() || nearestM > mostM ? OUT_OF_RANGE : MISSED;
  }

  private static double nearestM(Cone cone, Outline outline, Pose pose) {
    double heading = pose.heading().radians();
    return cone.nearestM(
        outline, pose.position().xM(), pose.position().zM(), Math.cos(heading), -Math.sin(heading));
  }

  private boolean inShadow(Pose pose) {
    return shadow.contains(placement.obstacleFromWorld(pose.position()));
  }

  /** As {@link DetectionRule#OVERLAP} has it: the tip in the shadow, or its edge in the cone. */
  private boolean meetsShadow(Pose pose) {
    return inShadow(pose)
        || shadow
            .edge()
            .map(edge -> nearestM(cone, edge.placed(placement), pose) <= spec.maxRangeM())
            .orElse(false);
  }

  private static int byLevel(Loudness.Sight sight) {
    if (!sight.isInRange()) {
      return OUT_OF_RANGE;
    }
    double weakDb = Math.min(WEAKEST_DB, -sight.excessDb());
    return weakDb > 0 ? TOO_WEAK + (int) Math.ceil(10 * weakDb) : MISSED;
  }
}
