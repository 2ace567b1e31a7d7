package simbad.experiments.demo;

import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import javax.vecmath.Vector3d;
import simbad.demo.Demo;
import simbad.experiments.control.Controller;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.FollowerRobot;
import simbad.experiments.run.Pace;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.Start;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarBelt;
import simbad.obstacles.SonarObstacle;
import simbad.sim.World;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;

/** A robot follows the edge of a detection shadow, ten times as fast as in the experiment. */
abstract class EdgeDemo extends Demo {
  private static final double SPEED_M_PER_S = 0.1;
  private static final double STEP_S = 0.05;
  private static final long SEED = 1;

  final FollowerRobot robot;
  final ObstacleType type;

  /** Real robots turn more slowly than the controller wants, and settle within a second. */
  static final Pace UNHURRIED = new Pace(0.35, 1);

  EdgeDemo(SonarObstacle obstacle) {
    this(obstacle, follower -> follower);
  }

  EdgeDemo(SonarObstacle obstacle, UnaryOperator<Controller> manner) {
    setWorldSize(8);
    worldViewPoint = World.VIEW_INWARDS;
    type = obstacle.type();
    add(obstacle);
    robot = robot("robot", type, middle(), manner);
    add(robot);
  }

  /**
   * Returns a robot that follows the edge round an obstacle.
   *
   * @param name of the robot
   * @param type of the obstacle
   * @param middle where the obstacle stands, unturned
   * @param manner in which the robot does what the controller decides
   */
  static FollowerRobot robot(
      String name, ObstacleType type, Vector3d middle, UnaryOperator<Controller> manner) {
    SonarSpec sonar = Catalogue.srf04();
    SonarBelt belt =
        new SonarBelt(SensorKind.SONARS, sonar, DetectionRule.SHADOW, new SplittableRandom(SEED));
    Controller controller = new EdgeFollower(Tuning.standard(SPEED_M_PER_S, STEP_S));
    Pose start = Start.standard(type, sonar);
    Point place = start.position();
    Pose shifted = Pose.of(place.xM() + middle.x, place.zM() + middle.z, start.heading().radians());
    return new FollowerRobot(name, shifted, belt, sonar.mountHeightM(), manner.apply(controller));
  }

  static Vector3d middle() {
    return new Vector3d();
  }
}
