package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
import simbad.sim.LightSensor;
import simbad.sim.Line;
import simbad.sim.PickSensor;
import simbad.sim.Plan;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SensorDevice;
import simbad.sim.SensorMatrix;
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

  @Test
  void resets_letSensorsSenseAtOnce_andTheSameEachTime() {
    assertEquals(List.of(1, 14, 1, 14), updatesInTwoEpisodes());
    environment.compatibility.add(Compatibility.RESETS_KEEP_THE_PHASE);
    // After 15 steps 0.75 s less two thirds are left, so that the second update comes 2 steps
    // sooner.
    assertEquals(List.of(1, 14, 1, 12), updatesInTwoEpisodes());
  }

  /** In which steps of two episodes of 15 steps a belt of 3 updates per second looks. */
  private List<Integer> updatesInTwoEpisodes() {
    List<Integer> steps = new ArrayList<>();
    int[] step = new int[1];
    Agent robot =
        new Agent(new Vector3d(), "robot") {
          {
            SensorDevice counter =
                new PickSensor() {
                  @Override
                  protected void update() {
                    steps.add(step[0]);
                  }
                };
            counter.setUpdatePerSecond(3);
            addSensorDevice(counter, new Vector3d(), 0);
          }
        };
    environment.add(robot);
    Simbatch simulation = new Simbatch(environment, false);
    for (int episode = 0; episode < 2; episode++) {
      simulation.reset();
      for (step[0] = 1; step[0] <= 15; step[0]++) {
        simulation.step();
      }
    }
    return steps;
  }

  @Test
  void plan_timesByItsOwnDurations_unlessSwitched() {
    checkPlan(1, -0.5, 1e-6);
    environment.compatibility.add(Compatibility.PLANS_TIME_BY_PREVIOUS);
    checkPlan(-15, 0, 1e-6);
  }

  /** The plan of the facts, 10 s of it. */
  private void checkPlan(double x, double z, double tolerance) {
    Agent robot =
        new Agent(new Vector3d(), "robot") {
          private final Plan plan = new Plan(this);

          @Override
          protected void initBehavior() {
            plan.forward(1, 1);
            plan.turn(Math.PI / 2, 0.5);
            plan.forward(0.5, 0.25);
            plan.reset();
          }

          @Override
          protected void performBehavior() {
            plan.doStep();
          }
        };
    environment.add(robot);
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    for (int i = 0; i < 200; i++) {
      simulation.step();
    }
    Point3d at = new Point3d();
    robot.getCoords(at);
    assertEquals(x, at.x, tolerance);
    assertEquals(z, at.z, tolerance);
  }

  @Test
  void nearness_isMutual_unlessSwitched() {
    Agent first = robotAt(0);
    CherryAgent cherry = new CherryAgent(new Vector3d(0.3, 0, 0), "cherry", 0.1f);
    environment.add(cherry);
    robotAt(5);
    run(first, 0, 0, 1);
    assertTrue(first.anOtherAgentIsVeryNear() && cherry.anOtherAgentIsVeryNear());
    environment.compatibility.add(Compatibility.NEARNESS_IS_ONE_SIDED);
    run(first, 0, 0, 1);
    assertTrue(first.anOtherAgentIsVeryNear() && !cherry.anOtherAgentIsVeryNear());
  }

  @Test
  void matrixEdge_isItsLastNumber_unlessSwitched() {
    assertEquals(0, new SensorMatrix(2, 2).get(1f, 1f));
    System.setProperty(Compatibility.PROPERTY, "matrix-edge-throws");
    try {
      SensorMatrix matrix = new SensorMatrix(2, 2);
      assertThrows(IndexOutOfBoundsException.class, () -> matrix.get(1f, 1f));
      assertEquals(0, matrix.get(0.99f, 0f));
    } finally {
      System.clearProperty(Compatibility.PROPERTY);
    }
  }

  @Test
  void robots_areRoundForRays_unlessSwitched() {
    assertEquals(0.7, rangeToARobot(), 1e-6);
    environment.compatibility.add(Compatibility.ROBOTS_ARE_PRISMS);
    // Of a prism of 15 sides with a corner at -z, the -x side is met within its edge.
    double apothem = 0.3 * Math.cos(Math.PI / 15);
    double range = rangeToARobot();
    assertTrue(range > 0.7 + 1e-6 && range <= 1 - apothem + 1e-6, "range " + range);
  }

  private double rangeToARobot() {
    Agent robot = robotAt(0);
    RangeSensorBelt belt = RobotFactory.addSonarBeltSensor(robot, 1);
    EnvironmentDescription own = new EnvironmentDescription();
    own.compatibility.addAll(environment.compatibility);
    own.add(robot);
    own.add(new Agent(new Vector3d(1.3, 0, 0), "other"));
    Simbatch simulation = new Simbatch(own, false);
    robot.moveToPosition(new Vector3d(0, 0.2, 0));
    simulation.step();
    return belt.getMeasurement(0);
  }

  @Test
  void lightSensors_sitWhereTheVersionHasThem() {
    Agent robot = robotAt(0);
    LightSensor left = RobotFactory.addLightSensorLeft(robot);
    run(robot, 0, 0, 1);
    assertEquals(0.8, left.position.length(), 1e-6);
    environment.compatibility.add(Compatibility.LIGHT_SENSORS_SIT_NEARER);
    Agent other = robotAt(3);
    LightSensor right = RobotFactory.addLightSensorRight(other);
    run(other, 0, 0, 1);
    assertEquals(0.6, right.position.length(), 1e-6);
  }

  @Test
  void touched_areTheSwitchesThatMattered() {
    Agent robot = robotAt(0);
    run(robot, 1, 0.1, 5);
    assertEquals(Set.of(), environment.touched());
    boxAt(0.82);
    run(robot, 1, 0.1, 5);
    assertEquals(Set.of(Compatibility.BLOCKED_ROBOTS_DO_NOT_TURN), environment.touched());
  }

  @Test
  void agent_belowTheFloor_isLiftedOntoIt() {
    Agent robot = new Agent(new Vector3d(0, -0.4, 0), "robot");
    environment.add(robot);
    run(robot, 0, 0, 1);
    Point3d at = new Point3d();
    robot.getCoords(at);
    assertEquals(0.25, at.y, 1e-6);
  }

  @Test
  void agents_comeAndGoWhileItRuns() {
    Agent robot = robotAt(0);
    Simbatch simulation = new Simbatch(environment, false);
    Agent late = new Agent(new Vector3d(2, 0, 0), "late");
    simulation.getSimulator().addAgent(late);
    simulation.step();
    assertEquals(1, late.getCounter());
    late.setPose(3, 1, Math.PI / 2);
    assertEquals(Math.PI / 2, late.getHeadingRad(), EPSILON);
    late.setHeadingRad(-1);
    assertEquals(-1, late.getHeadingRad(), EPSILON);
    assertEquals(3, x(late), EPSILON);
    assertEquals(new Vector3d(3, 0.25, 1), late.getTranslation());
    simulation.getSimulator().removeAgent(late);
    simulation.step();
    assertEquals(1, late.getCounter());
    assertEquals(List.of(robot), simulation.getSimulator().getAgentList());
  }

  /** What it is given is the program's own: to change it moves nothing. */
  @Test
  void translation_ofStaticObjects_isACopy() {
    Box box = boxAt(2);
    box.getTranslation().set(7, 7, 7);
    assertEquals(new Vector3d(2, 0.5, 0), box.getTranslation());
  }

  /**
   * The page's table and the program name the same switches, and each row says where it shows. A
   * row after an empty line would be no row of the table.
   */
  @Test
  void page_namesEverySwitch_andNoOther() throws IOException {
    Pattern row = Pattern.compile("\\|.*It matters .*\\| `([a-z0-9-]+)`[^|]*\\|");
    List<String> page = Files.readAllLines(Path.of("..", "docs", "compatibility.md"));
    int header = page.indexOf("| deviation | reason | switch |");
    List<String> rows =
        page.subList(header + 2, page.size()).stream()
            .takeWhile(line -> line.startsWith("|"))
            .toList();
    Set<String> named = new TreeSet<>();
    for (String line : rows) {
      Matcher matcher = row.matcher(line);
      assertTrue(matcher.matches(), line);
      assertTrue(named.add(matcher.group(1)), line);
    }
    Set<String> known = new TreeSet<>();
    for (Compatibility habit : Compatibility.values()) {
      known.add(habit.switchName());
    }
    assertEquals(known, named);
  }
}
