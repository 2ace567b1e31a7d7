package simbad.sonar.scene;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.ReadingRow;

/**
 * Readings as seen by a sensor before a scene that stands still: a robot's pose becomes that of its
 * sensor, and where the only obstacle was moved or turned, the sensor is moved or turned the other
 * way instead. What was read is the same.
 */
public final class SensorPoses {
  private SensorPoses() {}

  /**
   * Says why rows cannot be brought before a scene.
   *
   * @param setup the scene with the mounts
   * @param rows as in a file
   * @return empty where they can
   */
  public static Optional<String> problem(SensingSetup setup, List<ReadingRow> rows) {
    Map<String, Placement> mounts = setup.details().robotFromSensor();
    for (ReadingRow row : rows) {
      if (!mounts.isEmpty() && !mounts.containsKey(row.sensor())) {
        return Optional.of(
            "sensor: '"
                + row.sensor()
                + "' has no mount in the scene's sensors, which are "
                + String.join(", ", mounts.keySet()));
      }
      if (isMoved(row) && setup.scene().obstacles().size() != 1) {
        return Optional.of(
            "obstacle_x_m, obstacle_z_m, obstacle_turn_deg: expected a scene with one "
                + "obstacle, found "
                + setup.scene().obstacles().size());
      }
    }
    return Optional.empty();
  }

  private static boolean isMoved(ReadingRow row) {
    return !row.circumstances().obstacle().equals(MovedObstacle.UNMOVED);
  }

  /**
   * Brings rows before a scene.
   *
   * @param setup the scene with the mounts
   * @param rows for which there is no {@link #problem}
   * @return rows in the same order, with the sensor's own poses and an obstacle that is not moved
   */
  public static List<ReadingRow> of(SensingSetup setup, List<ReadingRow> rows) {
    boolean mounted = !setup.details().robotFromSensor().isEmpty();
    return rows.stream().map(row -> mounted || isMoved(row) ? seen(setup, row) : row).toList();
  }

  private static ReadingRow seen(SensingSetup setup, ReadingRow row) {
    Placement mount =
        setup.details().robotFromSensor().getOrDefault(row.sensor(), Placement.IDENTITY);
    Pose sensor = mounted(row.pose(), mount);
    if (!isMoved(row)) {
      return row.at(sensor, row.circumstances());
    }
    Placement scenes = setup.scene().obstacles().get(0).worldFromObstacle();
    Placement then = row.circumstances().obstacle().placement(scenes);
    return row.at(
        moved(sensor, then, scenes), row.circumstances().withObstacle(MovedObstacle.UNMOVED));
  }

  /**
   * Returns rows as a file beside the scene has them: of a sensor that has a mount the robot's
   * pose.
   *
   * @param setup the scene with the mounts
   * @param rows with the sensors' own poses, before an obstacle that is not moved
   */
  public static List<ReadingRow> undone(SensingSetup setup, List<ReadingRow> rows) {
    Map<String, Placement> mounts = setup.details().robotFromSensor();
    return rows.stream()
        .map(
            row ->
                mounts.containsKey(row.sensor())
                    ? row.at(
                        robot(row.pose(), mounts.getOrDefault(row.sensor(), Placement.IDENTITY)),
                        row.circumstances())
                    : row)
        .toList();
  }

  private static Pose robot(Pose sensor, Placement robotFromSensor) {
    double heading = sensor.heading().radians() - robotFromSensor.turnRad();
    Point way =
        new Placement(0, 0, heading)
            .worldFromObstacle(new Point(robotFromSensor.xM(), robotFromSensor.zM()));
    return Pose.of(sensor.position().xM() - way.xM(), sensor.position().zM() - way.zM(), heading);
  }

  /** Returns the pose of what is mounted on a robot. */
  static Pose mounted(Pose robot, Placement robotFromSensor) {
    Placement worldFromRobot =
        new Placement(robot.position().xM(), robot.position().zM(), robot.heading().radians());
    Point place =
        worldFromRobot.worldFromObstacle(new Point(robotFromSensor.xM(), robotFromSensor.zM()));
    return Pose.of(place.xM(), place.zM(), robot.heading().radians() + robotFromSensor.turnRad());
  }

  /** Returns the pose that is to an obstacle here what another one is to it there. */
  private static Pose moved(Pose sensor, Placement there, Placement here) {
    Point place = here.worldFromObstacle(there.obstacleFromWorld(sensor.position()));
    return Pose.of(
        place.xM(), place.zM(), sensor.heading().radians() + here.turnRad() - there.turnRad());
  }
}
