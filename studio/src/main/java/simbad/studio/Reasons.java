package simbad.studio;

import java.util.List;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.LevelModel;
import simbad.sonar.model.LevelSight;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.Cone;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.Outline;

/**
 * Why a sonar hears nothing, as the rule of its sensor has it. A fitted model's silence is
 * explained by the threshold rule, of which it is a change.
 */
final class Reasons {
  /** Numbers on the page's side. */
  static final int HEARD = 0;

  static final int NOTHING_IN_CONE = 1;
  static final int OUTSIDE_SHADOW = 2;
  static final int MISSED = 3;
  static final int OUT_OF_RANGE = 4;

  /** Too weak: by so many tenths of a decibel more than this number. */
  static final int TOO_WEAK = 100;

  private static final int WEAKEST_DB = 99;

  private final SensorKind sensor;
  private final SonarSpec spec;
  private final ObstacleType type;
  private final Cone cone;
  private final DetectionShadow shadow;
  private Placement placement = Placement.IDENTITY;
  private Outline outline;
  private LevelModel level;

  Reasons(SensorKind sensor, SonarSpec spec, ObstacleType type) {
    this.sensor = sensor;
    this.spec = spec;
    this.type = type;
    cone = new Cone(spec.coneHalfAngleRad());
    shadow = new DetectionShadow(type.thresholds().table());
    outline = type.outline();
    level = level();
  }

  /** The obstacle is elsewhere from now on. */
  void obstacleAt(Placement worldFromObstacle) {
    placement = worldFromObstacle;
    outline = type.outline().placed(worldFromObstacle);
    level = level();
  }

  private LevelModel level() {
    TableDetection detection = new TableDetection(type.thresholds().table());
    Obstacle placed = new Obstacle(type.name(), placement, type.outline(), detection);
    return new LevelModel(spec, new Scene(List.of(placed)));
  }

  /**
   * Returns the number of the reason.
   *
   * @param pose of a sonar that heard nothing
   */
  int of(Pose pose) {
    if (sensor.equals(SensorKind.LEVEL) || sensor.equals(SensorKind.LEVEL_NOISY)) {
      return byLevel(pose);
    }
    double heading = pose.heading().radians();
    double xM = pose.position().xM();
    double zM = pose.position().zM();
    double nearestM = cone.nearestM(outline, xM, zM, Math.cos(heading), -Math.sin(heading));
    if (nearestM == Double.POSITIVE_INFINITY) {
      return NOTHING_IN_CONE;
    }
    boolean original = sensor.equals(SensorKind.ORIGINAL) || sensor.equals(SensorKind.RAY);
    if (!original && !shadow.contains(placement.obstacleFromWorld(new Point(xM, zM)))) {
      return OUTSIDE_SHADOW;
    }
    double mostM = original ? DetectionRule.ORIGINAL_RANGE_M : spec.maxRangeM();
    return nearestM < spec.minRangeM() || nearestM > mostM ? OUT_OF_RANGE : MISSED;
  }

  private int byLevel(Pose pose) {
    LevelSight sight = level.sight(0, pose);
    double weakDb = Math.min(WEAKEST_DB, -sight.excessDb());
    if (sight.nearestM() < spec.minRangeM() || sight.nearestM() > spec.maxRangeM()) {
      return OUT_OF_RANGE;
    }
    return weakDb > 0 ? TOO_WEAK + (int) Math.ceil(10 * weakDb) : MISSED;
  }
}
