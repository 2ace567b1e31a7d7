package simbad.experiments.run;

import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.ThresholdTable;

/** Where an edge follower sets off, the obstacle at the origin. */
public final class Start {
  /** More than the robot and the sensor need. */
  private static final double CLEARANCE_M = 0.005;

  private Start() {}

  /**
   * Returns the start of the main experiment: on the bearing of the greatest threshold, half-way
   * out, where every sensor model hears the obstacle.
   *
   * @param type of the obstacle
   * @param sonar of the robot
   */
  public static Pose standard(ObstacleType type, SonarSpec sonar) {
    ThresholdTable table = type.thresholds().table();
    int farthest = 0;
    for (int i = 1; i < table.size(); i++) {
      farthest = table.valueM(i) > table.valueM(farthest) ? i : farthest;
    }
    double halfWayM = Math.min(table.greatestM(), DetectionRule.ORIGINAL_RANGE_M) / 2;
    double nearM = Math.max(FollowerRobot.RADIUS_M, sonar.minRangeM());
    double clearM = type.outline().reachM(0, 0) + nearM + CLEARANCE_M;
    double radiusM = Math.max(halfWayM, clearM);
    double bearing = table.bearingRad(farthest);
    return lookingInwards(new Point(radiusM * Math.sin(bearing), radiusM * Math.cos(bearing)));
  }

  /** Looks at the obstacle, so that a robot that hears nothing yet comes nearer. */
  static Pose lookingInwards(Point point) {
    return Pose.of(point.xM(), point.zM(), Math.atan2(point.zM(), -point.xM()));
  }
}
