package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Line;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/** What is mended, and that each switch brings the original's habit back. */
class CompatibilityTest {
  private static final double EPSILON = 1e-9;

  private final EnvironmentDescription environment = new EnvironmentDescription();

  private Agent robotAt(double x) {
    Agent robot = new Agent(new Vector3d(x, 0, 0), "robot");
    environment.add(robot);
    return robot;
  }

  private Box boxAt(double x) {
    Box box = new Box(new Vector3d(x, 0, 0), new Vector3f(1, 1, 1), environment);
    environment.add(box);
    return box;
  }

  private void run(Agent robot, double speed, double turn, int steps) {
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    robot.setTranslationalVelocity(speed);
    robot.setRotationalVelocity(turn);
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
  }

  private static double x(SimpleAgent agent) {
    Point3d coords = new Point3d();
    agent.getCoords(coords);
    return coords.x;
  }

  @Test
  void property_switches() {
    assertEquals(EnumSet.noneOf(Compatibility.class), Compatibility.parse(""));
    assertEquals(
        EnumSet.complementOf(EnumSet.of(Compatibility.LIGHT_SENSORS_SIT_NEARER)),
        Compatibility.parse("released-1.4"));
    assertTrue(Compatibility.parse("1.7").contains(Compatibility.LIGHT_SENSORS_SIT_NEARER));
    assertEquals(
        EnumSet.of(Compatibility.ROBOTS_PASS_ROBOTS, Compatibility.NO_ECHO_IS_INFINITE),
        Compatibility.parse("robots-pass-robots, no-echo-is-infinite"));
    assertFalse(Compatibility.parse("upstream").contains(Compatibility.NO_ECHO_IS_INFINITE));
    assertThrows(IllegalArgumentException.class, () -> Compatibility.parse("1.3"));
  }

  @Test
  void property_isReadByTheEnvironment() {
    System.setProperty(Compatibility.PROPERTY, "arguments-change");
    try {
      assertEquals(
          EnumSet.of(Compatibility.ARGUMENTS_CHANGE), new EnvironmentDescription().compatibility);
    } finally {
      System.clearProperty(Compatibility.PROPERTY);
    }
    assertTrue(environment.compatibility.isEmpty());
  }

  @Test
  void robot_isStoppedByRobot_beforeTheyTouch() {
    Agent robot = robotAt(0);
    Agent other = robotAt(1);
    run(robot, 1, 0, 20);
    // Spheres of 0.3 m touch at a distance of 0.6: the last free place is at 0.35 or at 0.4,
    // depending on rounding.
    assertTrue(x(robot) <= 0.4 + EPSILON && x(robot) >= 0.35 - EPSILON, "x = " + x(robot));
    assertTrue(robot.collisionDetected());
    assertFalse(other.collisionDetected());
    assertTrue(robot.anOtherAgentIsVeryNear());
  }

  @Test
  void robots_headOn_bothStop() {
    Agent robot = robotAt(0);
    Agent other = robotAt(2);
    other.rotateY(Math.PI);
    Simbatch simulation = new Simbatch(environment, false);
    other.rotateY(Math.PI);
    robot.setTranslationalVelocity(0.5);
    other.setTranslationalVelocity(0.5);
    for (int i = 0; i < 100; i++) {
      simulation.step();
      assertTrue(x(other) - x(robot) > 0.6 - EPSILON);
    }
    assertTrue(robot.collisionDetected() && other.collisionDetected());
  }

  @Test
  void robot_leavesOneThatItOverlaps() {
    Agent robot = robotAt(0);
    robotAt(0.3);
    run(robot, -1, 0, 20);
    assertEquals(-1, x(robot), EPSILON);
  }

  @Test
  void robot_passesCherry_andPushesRobotsUnderPhysics() {
    Agent robot = robotAt(0);
    environment.add(new CherryAgent(new Vector3d(0.5, 0, 0), "cherry", 0.1f));
    run(robot, 1, 0, 20);
    assertEquals(1, x(robot), EPSILON);
    Agent other = robotAt(1);
    environment.setUsePhysics(true);
    run(robot, 1, 0, 40);
    assertTrue(x(other) > 1.5 && x(robot) < x(other), x(robot) + ", " + x(other));
    assertFalse(robot.collisionDetected());
  }

  @Test
  void blockedRobot_turns_unlessSwitched() {
    Agent robot = robotAt(0);
    boxAt(0.82);
    run(robot, 1, 0.1, 20);
    assertTrue(robot.collisionDetected());
    assertEquals(0.1, robot.getHeadingRad(), EPSILON);
    assertEquals(0, robot.getOdometer());
    environment.compatibility.add(Compatibility.BLOCKED_ROBOTS_DO_NOT_TURN);
    run(robot, 1, 0.1, 20);
    assertEquals(0, robot.getHeadingRad(), EPSILON);
  }

  @Test
  void traversableBox_isPassed_unlessSwitched() {
    Agent robot = robotAt(0);
    Box box = boxAt(1);
    box.setCanBeTraversed(true);
    run(robot, 1, 0, 20);
    assertEquals(1, x(robot), EPSILON);
    environment.compatibility.add(Compatibility.TRAVERSABLE_OBJECTS_STOP);
    run(robot, 1, 0, 20);
    assertTrue(robot.collisionDetected());
    assertTrue(box.getCanBeTraversed());
  }

  @Test
  void line_isPassed_evenIfSwitched() {
    environment.compatibility.addAll(EnumSet.allOf(Compatibility.class));
    Agent robot = robotAt(0);
    environment.add(new Line(new Vector3d(0.5, 0, -1), 2, environment));
    run(robot, 1, 0, 20);
    assertEquals(1, x(robot), EPSILON);
  }

  @Test
  void noEcho_isTheMaximumRange_orInfinity() {
    Agent robot = robotAt(0);
    RangeSensorBelt belt = RobotFactory.addSonarBeltSensor(robot, 4, 0.6f);
    run(robot, 0, 0, 1);
    assertEquals(0.6f, belt.getMeasurement(0));
    environment.compatibility.add(Compatibility.NO_ECHO_IS_INFINITE);
    run(robot, 0, 0, 1);
    assertEquals(Double.POSITIVE_INFINITY, belt.getMeasurement(0));
    assertEquals(Double.POSITIVE_INFINITY, belt.getFrontQuadrantMeasurement());
  }

  @Test
  void arguments_stay_unlessSwitched() {
    Vector3d position = new Vector3d(1, 0, 1);
    Color3f color = new Color3f(1, 0, 0);
    new Box(position, new Vector3f(1, 1, 1), environment, color);
    assertEquals(new Vector3d(1, 0, 1), position);
    assertEquals(new Color3f(1, 0, 0), color);
    environment.compatibility.add(Compatibility.ARGUMENTS_CHANGE);
    new Box(position, new Vector3f(1, 1, 1), environment, color);
    assertEquals(new Vector3d(1, 0.5, 1), position);
    assertEquals(new Color3f(0.8f, 0, 0), color);
  }
}
