package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bodies fall, slide, meet and bounce as closed forms say. g = 9.8 m/s^2, steps of 0.05 s. */
class PhysicsTest {
  private static final double STEP_S = 0.05;
  private static final double G = PhysicalEngine.g;
  private static final double EXACT = 1e-9;

  private final EnvironmentDescription environment = new EnvironmentDescription();

  PhysicsTest() {
    environment.setUsePhysics(true);
  }

  private BallAgent ball(double x, double y, double z, float radius, float mass) {
    BallAgent ball = new BallAgent(new Vector3d(x, y, z), "ball", environment.red, radius, mass);
    ball.staticFrictionCoefficient = 0;
    environment.add(ball);
    return ball;
  }

  private Simulator simulator() {
    Simulator simulator = new Simulator(null, new World(environment), environment);
    simulator.initBehaviors();
    return simulator;
  }

  private static void run(Simulator simulator, int steps) {
    for (int i = 0; i < steps; i++) {
      simulator.simulateOneStep();
    }
  }

  private static Point3d at(SimpleAgent agent) {
    Point3d at = new Point3d();
    agent.getCoords(at);
    return at;
  }

  private static Vector3d momentum(SimpleAgent... agents) {
    Vector3d sum = new Vector3d();
    for (SimpleAgent agent : agents) {
      sum.scaleAdd(agent.getMass(), agent.linearVelocity, sum);
    }
    return sum;
  }

  private static double energy(SimpleAgent... agents) {
    double sum = 0;
    for (SimpleAgent agent : agents) {
      sum += agent.getMass() * agent.linearVelocity.lengthSquared() / 2;
    }
    return sum;
  }

  /** y = h - g t^2 / 2, whatever the mass. */
  @ParameterizedTest
  @CsvSource({"0.25", "1", "50"})
  void fall_isThatOfEveryMass(float mass) {
    BallAgent ball = ball(0, 10, 0, 0.1f, mass);
    Simulator simulator = simulator();
    for (int i = 1; i <= 20; i++) {
      run(simulator, 1);
      double t = i * STEP_S;
      assertEquals(10.0 + 0.1f - G * t * t / 2, at(ball).y, EXACT);
    }
  }

  @Test
  void fall_endsOnTheFloor() {
    BallAgent ball = ball(0, 1, 0, 0.1f, 1);
    run(simulator(), 100);
    assertEquals(0.1f, at(ball).y, EXACT);
    assertEquals(new Vector3d(), ball.linearVelocity);
  }

  @Test
  void robot_falls_whileItDrives() {
    Agent robot = new Agent(new Vector3d(0, 2, 0), "robot");
    environment.add(robot);
    Simulator simulator = simulator();
    robot.setTranslationalVelocity(1);
    run(simulator, 10);
    assertEquals(2.25 - G / 8, at(robot).y, EXACT);
    assertEquals(0.5, at(robot).x, EXACT);
    run(simulator, 10);
    assertEquals(0.25, at(robot).y, EXACT);
    assertEquals(1, at(robot).x, EXACT);
  }

  /** As the facts of the original say: a robot of 50 kg is down after one step. */
  @Test
  void switch_bringsBackFallingByMass() {
    environment.compatibility.add(Compatibility.GRAVITY_GROWS_WITH_MASS);
    Agent robot = new Agent(new Vector3d(0, 1, 0), "robot");
    environment.add(robot);
    BallAgent ball = ball(5, 10, 0, 0.1f, 0.25f);
    run(simulator(), 1);
    assertEquals(0.25, at(robot).y, EXACT);
    assertEquals(-2.45 * STEP_S, ball.linearVelocity.y, 1e-6);
  }

  @Test
  void whatHasNoMass_orIsDetached_hangs() {
    CherryAgent cherry = new CherryAgent(new Vector3d(0, 3, 0), "cherry", 0.1f);
    environment.add(cherry);
    BallAgent ball = ball(1, 3, 0, 0.1f, 1);
    ball.detach();
    run(simulator(), 20);
    assertEquals(3.1, at(cherry).y, 1e-6);
    assertEquals(3.1, at(ball).y, 1e-6);
  }

  /** s = v^2 / (2 mu g), the last step's part rounded: at most mu g dt^2 / 8 off. */
  @ParameterizedTest
  @CsvSource({"1, 0.1", "2, 0.1", "1.7, 0.35", "3, 0.8"})
  void friction_stopsWithinTheBrakingDistance(double speed, float friction) {
    BallAgent ball = ball(0, 0, 0, 0.1f, 2);
    ball.staticFrictionCoefficient = friction;
    Simulator simulator = simulator();
    ball.linearVelocity.set(speed * 0.6, 0, speed * 0.8);
    run(simulator, 400);
    double wayM = speed * speed / (2 * friction * G);
    assertEquals(wayM, Math.hypot(at(ball).x, at(ball).z), friction * G * STEP_S * STEP_S / 8);
    assertEquals(0.75, at(ball).x / at(ball).z, EXACT);
    assertEquals(0, ball.linearVelocity.length());
  }

  @Test
  void friction_dynamicComesBeforeStatic() {
    BallAgent ball = ball(0, 0, 0, 0.1f, 2);
    ball.staticFrictionCoefficient = 0.9f;
    ball.dynamicFrictionCoefficient = 0.1f;
    Simulator simulator = simulator();
    ball.linearVelocity.x = 1;
    run(simulator, 1);
    assertEquals(1 - 0.1f * G * STEP_S, ball.linearVelocity.x, EXACT);
  }

  @Test
  void switch_bringsBackTheJitter() {
    environment.compatibility.add(Compatibility.FRICTION_NEVER_STOPS);
    BallAgent ball = ball(0, 0, 0, 0.1f, 1);
    ball.staticFrictionCoefficient = 0.1f;
    Simulator simulator = simulator();
    ball.linearVelocity.x = 0.03;
    run(simulator, 1);
    double before = ball.linearVelocity.x;
    assertTrue(before < 0);
    run(simulator, 1);
    assertTrue(ball.linearVelocity.x > 0);
  }

  @Test
  void equalBalls_exchangeTheirVelocities() {
    BallAgent one = ball(0, 0, 0, 0.1f, 0.5f);
    BallAgent other = ball(1, 0, 0, 0.1f, 0.5f);
    Simulator simulator = simulator();
    one.linearVelocity.x = 1.5;
    other.linearVelocity.x = -0.5;
    run(simulator, 30);
    assertEquals(-0.5, one.linearVelocity.x, EXACT);
    assertEquals(1.5, other.linearVelocity.x, EXACT);
    assertFalse(one.interactionDetected());
  }

  /** v1' = (m1 - m2) / (m1 + m2) v1 and v2' = 2 m1 / (m1 + m2) v1. */
  @Test
  void unequalBalls_shareByTheirMasses() {
    BallAgent heavy = ball(0, 0, 0, 0.2f, 3);
    BallAgent light = ball(0.52, 0, 0, 0.2f, 1);
    Simulator simulator = simulator();
    heavy.linearVelocity.x = 1;
    run(simulator, 2);
    assertFalse(heavy.interactionDetected());
    run(simulator, 1);
    assertTrue(heavy.interactionDetected() && light.interactionDetected());
    assertEquals(0.5, heavy.linearVelocity.x, EXACT);
    assertEquals(1.5, light.linearVelocity.x, EXACT);
  }

  /** Equal balls part at right angles, whichever way they meet. */
  @Test
  void obliqueImpact_ofEqualBalls_partsAtRightAngles() {
    BallAgent one = ball(0, 0, 0, 0.1f, 1);
    BallAgent other = ball(1, 0, 0.12, 0.1f, 1);
    Simulator simulator = simulator();
    one.linearVelocity.x = 2;
    run(simulator, 15);
    assertTrue(other.linearVelocity.z > 0.1, "hit to the side");
    assertEquals(0, one.linearVelocity.dot(other.linearVelocity), EXACT);
    // Along the line of centres at contact: sin = 0.12 / 0.2.
    assertEquals(0.6, other.linearVelocity.z / other.linearVelocity.length(), 1e-6);
  }

  /** Fast enough to jump over the other one within a step. */
  @Test
  void fastBall_doesNotTunnel() {
    BallAgent bullet = ball(0, 0, 0, 0.05f, 1);
    BallAgent target = ball(1.5, 0, 0, 0.05f, 1);
    Simulator simulator = simulator();
    bullet.linearVelocity.x = 20;
    run(simulator, 2);
    assertEquals(0, bullet.linearVelocity.x, EXACT);
    assertEquals(20, target.linearVelocity.x, EXACT);
  }

  @Test
  void fastBall_doesNotTunnelThroughAWall() {
    environment.add(new Box(new Vector3d(2, 0, 0), new Vector3f(0.1f, 1, 9), environment));
    BallAgent bullet = ball(0, 0, 0, 0.05f, 1);
    Simulator simulator = simulator();
    bullet.linearVelocity.x = 30;
    run(simulator, 4);
    assertEquals(-30, bullet.linearVelocity.x, EXACT);
    assertTrue(at(bullet).x < 1.9);
  }

  @Test
  void manyImpacts_conserveMomentumAndEnergy() {
    SplittableRandom random = new SplittableRandom(4);
    List<SimpleAgent> balls = new ArrayList<>();
    for (int i = 0; i < 25; i++) {
      balls.add(ball(i % 5, 0, Math.floorDiv(i, 5), 0.2f, (float) random.nextDouble(0.2, 3)));
    }
    Simulator simulator = simulator();
    balls.forEach(b -> b.linearVelocity.set(random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2)));
    SimpleAgent[] all = balls.toArray(SimpleAgent[]::new);
    Vector3d momentum = momentum(all);
    double energy = energy(all);
    int impacts = 0;
    for (int i = 0; i < 400; i++) {
      run(simulator, 1);
      impacts += balls.stream().anyMatch(SimpleAgent::interactionDetected) ? 1 : 0;
    }
    Vector3d change = momentum(all);
    change.sub(momentum);
    assertTrue(impacts > 10, impacts + " impacts");
    assertEquals(0, change.length(), EXACT);
    assertEquals(energy, energy(all), EXACT);
  }

  /** Angle of incidence is angle of reflection, at a wall that stands anywhere. */
  @ParameterizedTest
  @CsvSource({"2, 0", "-2, 0", "0, 2", "0, -2"})
  void ball_isMirroredByAWall(double wallX, double wallZ) {
    environment.add(
        new Box(
            new Vector3d(7 + wallX, 0, 5 + wallZ),
            new Vector3f(wallX == 0 ? 20 : 0.3f, 1, wallZ == 0 ? 20 : 0.3f),
            environment));
    BallAgent ball = ball(7, 0, 5, 0.2f, 1);
    Simulator simulator = simulator();
    ball.linearVelocity.set(wallX + 0.3, 0, wallZ + 0.3);
    Vector3d before = new Vector3d(ball.linearVelocity);
    run(simulator, 40);
    double alongX = wallX == 0 ? 1 : -1;
    assertArrayEquals(
        new double[] {alongX * before.x, 0, -alongX * before.z},
        new double[] {ball.linearVelocity.x, ball.linearVelocity.y, ball.linearVelocity.z},
        EXACT);
    assertTrue(Math.abs(at(ball).x - 7 - wallX) >= (wallX == 0 ? 0 : 0.35));
  }

  /** Elastic: it rises as high as it fell from, again and again, and does not gain. */
  @Test
  void ball_onABox_risesAsHighAsItFell() {
    environment.add(new Box(new Vector3d(), new Vector3f(3, 0.5f, 3), environment));
    BallAgent ball = ball(0, 2, 0, 0.1f, 1);
    Simulator simulator = simulator();
    double energy = G * at(ball).y;
    for (int i = 0; i < 2000; i++) {
      run(simulator, 1);
      double v = ball.linearVelocity.y;
      assertEquals(energy, G * at(ball).y + v * v / 2, 1e-6);
    }
  }

  @Test
  void ball_betweenFourWalls_staysWithItsSpeed() {
    for (int side = 0; side < 4; side++) {
      Wall wall =
          new Wall(
              new Vector3d(2 * Math.cos(side * Math.PI / 2), 0, 2 * Math.sin(side * Math.PI / 2)),
              5,
              1,
              environment);
      wall.rotate90(side + 1);
      environment.add(wall);
    }
    BallAgent ball = ball(0.3, 0, 0.1, 0.2f, 1);
    Simulator simulator = simulator();
    ball.linearVelocity.set(1.3, 0, 0.7);
    double speed = ball.linearVelocity.length();
    for (int i = 0; i < 4000; i++) {
      run(simulator, 1);
      assertTrue(Math.abs(at(ball).x) < 1.66 && Math.abs(at(ball).z) < 1.66, "at " + at(ball));
    }
    assertEquals(speed, ball.linearVelocity.length(), EXACT);
  }

  /** v1' and v2' as for any two bodies; in the next step its motors drive the robot again. */
  @Test
  void robot_pushesABall_andDrivesOn() {
    Agent robot = new Agent(new Vector3d(), "robot");
    environment.add(robot);
    BallAgent ball = ball(1, 0, 0, 0.25f, 0.25f);
    Simulator simulator = simulator();
    robot.setTranslationalVelocity(0.5);
    while (!ball.interactionDetected()) {
      run(simulator, 1);
      assertTrue(robot.getCounter() < 40, "no contact");
    }
    // An impact without a rebound: both go on with the speed of their centre of mass.
    assertEquals(50 * 0.5 / 50.25, ball.linearVelocity.x, EXACT);
    run(simulator, 1);
    assertEquals(0.5, robot.linearVelocity.x, EXACT);
    assertFalse(robot.collisionDetected());
  }

  @Test
  void robot_doesNotPressABallThroughAWall() {
    environment.add(new Box(new Vector3d(1.6, 0, 0), new Vector3f(0.4f, 1, 3), environment));
    Agent robot = new Agent(new Vector3d(), "robot");
    environment.add(robot);
    BallAgent ball = ball(1, 0, 0, 0.25f, 0.25f);
    Simulator simulator = simulator();
    robot.setTranslationalVelocity(0.5);
    for (int i = 0; i < 400; i++) {
      run(simulator, 1);
      assertTrue(at(ball).x <= 1.15 && at(ball).x - at(robot).x > 0.5, at(robot) + " " + at(ball));
    }
    assertTrue(at(robot).x > 0.3);
  }

  @Test
  void sameStart_samePath() {
    Point3d first = chaos();
    assertEquals(first, chaos());
  }

  private Point3d chaos() {
    EnvironmentDescription billiards = new EnvironmentDescription();
    billiards.setUsePhysics(true);
    List<BallAgent> balls = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      balls.add(
          new BallAgent(new Vector3d(i % 4 * 0.45, 0, Math.floorDiv(i, 4) * 0.43), "ball", 0.2f));
      billiards.add(balls.get(i));
    }
    Simulator simulator = new Simulator(null, new World(billiards), billiards);
    balls.get(0).linearVelocity.set(3, 0, 2);
    run(simulator, 300);
    return at(balls.get(11));
  }

  @Test
  void contactNormal_isThatOfTheNearestPoint() {
    BoundingBox box = new BoundingBox(new Point3d(4, 0, -1), new Point3d(6, 2, 1));
    checkNormal(new Vector3d(-1, 0, 0), new Point3d(3.5, 1, 0), box);
    checkNormal(new Vector3d(0, 1, 0), new Point3d(5, 2.5, 0.5), box);
    checkNormal(new Vector3d(0.6, 0, 0.8), new Point3d(6.3, 1, 1.4), box);
    checkNormal(new Vector3d(0, 0, -1), new Point3d(5, 1, -0.9), box);
    checkNormal(new Vector3d(1, 0, 0), new Point3d(5.8, 1, 0), box);
  }

  private static void checkNormal(Vector3d expected, Point3d centre, BoundingBox box) {
    Vector3d normal = new Vector3d();
    new PhysicalEngine().computeContactNormal(new BoundingSphere(centre, 0.6), box, normal);
    assertTrue(expected.epsilonEquals(normal, EXACT), "normal " + normal);
  }

  /** A ball between a wall and a robot that comes nearer is not squeezed, and gets no faster. */
  @Test
  void pinchedBall_restsBetweenRobotAndWall() {
    Agent robot = new Agent(new Vector3d(), "robot");
    environment.add(robot);
    environment.add(new Box(new Vector3d(2, 0, 0), new Vector3f(1, 1, 4), environment));
    BallAgent ball = ball(0.9, 0, 0, 0.25f, 0.25f);
    Simulator simulator = simulator();
    robot.setTranslationalVelocity(0.5);
    for (int i = 0; i < 400; i++) {
      run(simulator, 1);
      assertTrue(ball.linearVelocity.length() < 0.5 + EXACT, "step " + i);
      double gap = ball.nextX() - ball.instantTranslation.x - robot.placement().xM();
      assertTrue(Math.abs(gap) > 0.55 - EXACT, "step " + i + ", gap " + gap);
    }
    assertTrue(robot.collisionDetected());
  }

  @Test
  void switch_letsRobotsKickBalls() {
    environment.compatibility.add(Compatibility.IMPACTS_LEAVE_OVERLAPS);
    Agent robot = new Agent(new Vector3d(), "robot");
    environment.add(robot);
    BallAgent ball = ball(1, 0, 0, 0.25f, 0.25f);
    Simulator simulator = simulator();
    robot.setTranslationalVelocity(0.5);
    for (int i = 0; i < 40 && !ball.interactionDetected(); i++) {
      run(simulator, 1);
    }
    assertEquals(2 * 50 * 0.5 / 50.25, ball.linearVelocity.x, EXACT);
  }
}
