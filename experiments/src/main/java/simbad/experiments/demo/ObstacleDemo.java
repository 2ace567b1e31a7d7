package simbad.experiments.demo;

import java.util.Optional;
import simbad.demo.Demo;
import simbad.experiments.motion.DiagnosedKinematic;
import simbad.experiments.run.RobotKind;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;

/** A robot circles any obstacle at the edge of its detection shadow. */
public final class ObstacleDemo extends EdgeDemo {
  /**
   * Creates the environment.
   *
   * @param type of the obstacle
   */
  public ObstacleDemo(ObstacleType type) {
    super(new SonarObstacle(middle(), 0, type));
  }

  private ObstacleDemo(ObstacleType type, RobotKind moving) {
    super(new SonarObstacle(middle(), 0, type), UNHURRIED::of);
    robot.movesBy(new DiagnosedKinematic(moving.motion()));
  }

  /**
   * Returns the demo of an obstacle on a robot that moves otherwise than it is told, and is given
   * the time that it needs.
   *
   * @param demo of an obstacle
   * @param moving how the robot moves
   * @return empty where the demo is of something else
   */
  public static Optional<Demo> on(Demo demo, RobotKind moving) {
    return demo instanceof EdgeDemo edge
        ? Optional.of(new ObstacleDemo(edge.type, moving))
        : Optional.empty();
  }
}
