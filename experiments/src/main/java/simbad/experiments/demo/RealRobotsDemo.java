package simbad.experiments.demo;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import simbad.demo.Demo;
import simbad.experiments.motion.DiagnosedKinematic;
import simbad.experiments.motion.ShippedRobots;
import simbad.experiments.run.FollowerRobot;
import simbad.obstacles.AngleObstacle;
import simbad.obstacles.SonarObstacle;
import simbad.sim.World;

/**
 * Four robots with one controller, each round an angle of its own: one does what it is told, the
 * others move as three real robots were found to move. All are given the time that these need.
 */
public final class RealRobotsDemo extends Demo {
  private static final double APART_M = 7;

  /** Nobody's motion. */
  private static final String AS_TOLD = "as told";

  final List<SonarObstacle> angles = new ArrayList<>();
  final List<FollowerRobot> robots = new ArrayList<>();

  /** Creates the environment. */
  public RealRobotsDemo() {
    setWorldSize((float) (3 * APART_M));
    worldViewPoint = World.VIEW_FROM_TOP;
    List<String> real = ShippedRobots.names();
    place(AS_TOLD, -1, -1);
    place(real.get(0), 1, -1);
    place(real.get(1), -1, 1);
    place(real.get(2), 1, 1);
  }

  private void place(String name, int column, int row) {
    Vector3d middle = new Vector3d(column * APART_M / 2, 0, row * APART_M / 2);
    SonarObstacle obstacle = new AngleObstacle(middle, 0);
    FollowerRobot robot = EdgeDemo.robot(name, obstacle.type(), middle, EdgeDemo.UNHURRIED::of);
    if (!name.equals(AS_TOLD)) {
      robot.movesBy(new DiagnosedKinematic(ShippedRobots.motion(name)));
    }
    angles.add(obstacle);
    robots.add(robot);
    add(obstacle);
    add(robot);
  }
}
