package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.Transform3D;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.scene.BodyPart;
import simbad.sim.Agent;
import simbad.sim.Arch;
import simbad.sim.BallAgent;
import simbad.sim.BaseObject;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.Robot;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;
import simbad.sim.StaticObject;
import simbad.sim.Wall;

/** Worlds as users build them, with expectations worked out by hand. */
class FacadeTest {
  private static final double EPSILON = 1e-6;

  private final EnvironmentDescription environment = new EnvironmentDescription();

  /** A robot with four sonars that sense in every step: ahead, left, behind, right. */
  private Agent robotAt(double x, double z) {
    Agent robot = new Robot(new Vector3d(x, 0, z), "robot");
    belt(robot, 4);
    environment.add(robot);
    return robot;
  }

  private static RangeSensorBelt belt(Agent robot, int sonars) {
    RangeSensorBelt belt = RobotFactory.addSonarBeltSensor(robot, sonars);
    belt.setUpdateOnEachFrame(true);
    return belt;
  }

  private Box box(double x, double z, float side) {
    Box box = new Box(new Vector3d(x, 0, z), new Vector3f(side, 1, side), environment);
    environment.add(box);
    return box;
  }

  private Simbatch run(int steps) {
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    step(simulation, steps);
    return simulation;
  }

  private static void step(Simbatch simulation, int steps) {
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
  }

  private static void checkRange(double expectedM, Agent robot, int sonar) {
    RangeSensorBelt belt = (RangeSensorBelt) robot.getSensorDevice(0);
    assertEquals(expectedM, belt.getMeasurement(sonar), EPSILON);
    assertEquals(expectedM < 1.5, belt.hasHit(sonar));
  }

  @Test
  void turnedBox_isHitAtItsTrueCorner_butStopsAtItsBounds() {
    // A square of side 1 turned by 45 degrees has its corner 0.7071 from its middle.
    Agent robot = robotAt(0, 0);
    box(2, 0, 1).rotateY(Math.PI / 4);
    Simbatch simulation = run(1);
    checkRange(2 - Math.sqrt(0.5) - 0.3, robot, 0);
    // Half a metre beside the corner the true surface is half a metre further away.
    robot.moveToPosition(0, 0.5);
    step(simulation, 1);
    checkRange(2 - Math.sqrt(0.5) + 0.5 - 0.3, robot, 0);
    // The world-frame box is a square of side 1.414: its face is met at 1.2929 all along.
    robot.setTranslationalVelocity(0.5);
    step(simulation, 100);
    assertTrue(robot.collisionDetected());
    assertEquals(0.975, x(robot), EPSILON);
  }

  /** Programs subtract corners in any order: only the size counts. */
  @Test
  void boxOfNegativeSides_standsWhereItWouldOtherwise() {
    Agent robot = robotAt(0, 0);
    environment.add(new Wall(new Vector3d(1.5, 0, 0), -1, -2, 1, environment));
    environment.add(new Box(new Vector3d(0, 1, -1), new Vector3f(1, -1, 1), environment));
    run(1);
    checkRange(0.7, robot, 0);
    checkRange(0.2, robot, 1);
  }

  private static double x(SimpleAgent agent) {
    Point3d coords = new Point3d();
    agent.getCoords(coords);
    return coords.x;
  }

  @Test
  void arch_isOpenInTheMiddle() {
    Agent robot = robotAt(0, -2);
    Arch arch = new Arch(new Vector3d(0, 0, 0), environment);
    environment.add(arch);
    Simbatch simulation = new Simbatch(environment, false);
    robot.rotateY(-Math.PI / 2);
    robot.setTranslationalVelocity(0.5);
    step(simulation, 80);
    assertEquals(2, robot.getOdometer(), EPSILON);
    checkRange(0.7, robot, 1);
    checkRange(0.7, robot, 3);
    step(simulation, 100);
    assertFalse(robot.collisionDetected());
  }

  @Test
  void arch_quarterTurned_blocksTheWay() {
    Agent robot = robotAt(1.5, -2);
    Arch arch = new Arch(new Vector3d(0, 0, 0), environment);
    environment.add(arch);
    assertSame(3, arch.getSolid().parts().size());
    Simbatch simulation = run(0);
    robot.rotateY(-Math.PI / 2);
    step(simulation, 1);
    checkRange(1.2, robot, 0);
    arch.rotate90(1);
    step(simulation, 1);
    checkRange(1.5, robot, 0);
  }

  @Test
  void traversableObject_isSeenButDoesNotStop() {
    Agent robot = robotAt(0, 0);
    box(1.5, 0, 1).setCanBeTraversed(true);
    Simbatch simulation = run(1);
    checkRange(0.7, robot, 0);
    robot.setTranslationalVelocity(1);
    step(simulation, 60);
    assertEquals(3, robot.getOdometer(), EPSILON);
  }

  @Test
  void otherRobot_isSeenAtOnceAndWithoutLag() {
    Agent robot = robotAt(0, 0);
    Agent other = robotAt(1.5, 0);
    Simbatch simulation = run(1);
    checkRange(0.9, robot, 0);
    checkRange(0.9, other, 2);
    other.setTranslationalVelocity(1);
    step(simulation, 1);
    checkRange(0.9, robot, 0);
    step(simulation, 1);
    checkRange(0.95, robot, 0);
  }

  @Test
  void robots_driveThroughEachOther_ifSwitched() {
    environment.compatibility.add(Compatibility.ROBOTS_PASS_ROBOTS);
    Agent robot = robotAt(0, 0);
    Agent other = robotAt(1, 0);
    Simbatch simulation = run(1);
    robot.setTranslationalVelocity(1);
    assertFalse(robot.anOtherAgentIsVeryNear());
    step(simulation, 20);
    assertSame(other, robot.getVeryNearAgent());
    assertSame(robot, other.getVeryNearAgent());
    assertFalse(robot.collisionDetected());
    assertEquals(1, x(robot), EPSILON);
  }

  @Test
  void cherry_pickedDuringAStep_isGone() {
    List<String> picked = new ArrayList<>();
    Agent robot =
        new Agent(new Vector3d(0, 0, 0), "picker") {
          @Override
          protected void performBehavior() {
            setTranslationalVelocity(1);
            if (anOtherAgentIsVeryNear()) {
              picked.add(getVeryNearAgent().getName());
              getVeryNearAgent().detach();
            }
          }
        };
    belt(robot, 4);
    environment.add(robot);
    for (int i = 1; i <= 5; i++) {
      environment.add(new CherryAgent(new Vector3d(i, 0.4, 0), "cherry" + i, 0.15f));
    }
    run(150);
    assertEquals(List.of("cherry1", "cherry2", "cherry3", "cherry4", "cherry5"), picked);
    checkRange(1.5, robot, 2);
    assertNull(robot.getVeryNearAgent());
  }

  @Test
  void detachedObject_comesBack() {
    Agent robot = robotAt(0, 0);
    Box box = box(1.5, 0, 1);
    Simbatch simulation = run(1);
    checkRange(0.7, robot, 0);
    box.detach();
    step(simulation, 1);
    checkRange(1.5, robot, 0);
    box.attach();
    step(simulation, 1);
    checkRange(0.7, robot, 0);
  }

  @Test
  void objectDetachedBeforeTheStart_isNotThere() {
    Agent robot = robotAt(0, 0);
    box(1.5, 0, 1).detach();
    run(1);
    checkRange(1.5, robot, 0);
  }

  @Test
  void arguments_areNotChanged() {
    Vector3d position = new Vector3d(1, 2, 3);
    Color3f color = new Color3f(1, 1, 1);
    new Box(position, new Vector3f(1, 1, 1), environment, color);
    new Wall(position, 2, 1, environment);
    new Arch(position, environment);
    new BallAgent(position, "ball", color, 0.1f, 1).moveToStartPosition();
    assertEquals(new Vector3d(1, 2, 3), position);
    assertEquals(new Color3f(1, 1, 1), color);
    assertEquals(new Color3f(0, 0, 1), environment.blue);
  }

  @Test
  void solid_tellsShapesAndTheirPlaces() {
    Box box = box(1, 2, 3);
    BodyPart part = box.getSolid().parts().get(0);
    assertEquals(BoxShape.ofSides(3, 1, 3), part.shape());
    box.translateTo(new Vector3d(1, 0, 0));
    box.rotateY(0.5);
    assertEquals(2, part.worldFromPart().xM(), EPSILON);
    assertEquals(0.5, part.worldFromPart().headingRad(), EPSILON);
    assertEquals(1, part.extent().maxY(), EPSILON);
  }

  @Test
  void wall_hasGivenSizes() {
    Agent robot = robotAt(0, 0);
    environment.add(new Wall(new Vector3d(1, 0, 0), 0.4f, 3, 1, environment));
    environment.add(new Wall(new Vector3d(0, 0, -1), 3, 1, environment));
    run(1);
    checkRange(0.5, robot, 0);
    checkRange(0.55, robot, 1);
  }

  @Test
  void sonarHeight_seesOnlyWhatReachesIt() {
    Agent robot = robotAt(0, 0);
    environment.add(new Box(new Vector3d(1, 0, 0), new Vector3f(1, 0.49f, 1), environment));
    environment.add(new Box(new Vector3d(-1, 0, 0), new Vector3f(1, 0.5f, 1), environment));
    run(1);
    checkRange(1.5, robot, 0);
    checkRange(0.2, robot, 2);
  }

  @Test
  void map_isCentred() {
    environment.addMap(new String[] {"#  ", "   ", "  #"});
    Agent robot = robotAt(-1, 1);
    run(1);
    // Boxes stand at (-1, -1) and (1, 1).
    checkRange(1.2, robot, 0);
    checkRange(1.2, robot, 1);
    checkRange(1.5, robot, 2);
  }

  @Test
  void transforms_giveThePlacement() {
    Box box = box(1, 2, 3);
    box.rotate90(1);
    box.translateTo(new Vector3d(0, 0, 1));
    Transform3D transform = new Transform3D();
    box.getTranslationTransform(transform);
    Vector3d translation = new Vector3d();
    transform.get(translation);
    assertEquals(new Vector3d(1, 0.5, 3), translation);
    box.getRotationTransform(transform);
    Vector3d forward = new Vector3d(1, 0, 0);
    transform.transform(forward);
    assertEquals(-1, forward.z, EPSILON);
    assertEquals(Math.PI / 2, box.getHeadingRad(), EPSILON);
  }

  @Test
  void tiltedPost_isHitWhereItIs() {
    // A post of 4 m by 0.2 m by 0.2 m lies along x; tilted up by 90 degrees it stands.
    Agent robot = robotAt(0, 0);
    Box post = new Box(new Vector3d(1, 0.4, 0), new Vector3f(4, 0.2f, 0.2f), environment);
    post.rotateZ(Math.PI / 2);
    environment.add(post);
    run(1);
    checkRange(0.6, robot, 0);
  }

  @Test
  void environment_usedTwice_givesTheSameRun() {
    Agent robot = robotAt(0, 0);
    box(3, 0, 1);
    run(5);
    robot.setTranslationalVelocity(0.5);
    Simbatch second = run(5);
    checkRange(1.5, robot, 0);
    robot.setTranslationalVelocity(0.5);
    step(second, 150);
    assertTrue(robot.collisionDetected());
    second.dispose();
  }

  @Test
  void unusedDefaults_areSimbads() {
    assertEquals(new Vector3d(0, 5, 20), environment.light1Position);
    assertEquals(new Vector3d(20, 5, 0), environment.light2Position);
    environment.light1SetPosition(1, 2, 3);
    environment.light2SetPosition(4, 5, 6);
    environment.setWorldSize(30);
    environment.showAxis(false);
    environment.setUsePhysics(true);
    assertEquals(new Vector3d(1, 2, 3), environment.light1Position);
    assertEquals(new Vector3d(4, 5, 6), environment.light2Position);
    assertEquals(30, environment.worldSize);
    assertFalse(environment.hasAxis);
    assertTrue(environment.usePhysics);
  }

  @Test
  void devices_areListed() {
    Agent robot = robotAt(0, 0);
    RobotFactory.addBumperBeltSensor(robot);
    RobotFactory.addLamp(robot);
    assertEquals(2, robot.getSensorList().size());
    assertEquals(1, robot.getActuatorList().size());
    assertEquals("bumpers", robot.getSensorDevice(1).getName());
    assertEquals(6, robot.getSensorDevice(1).getUpdatePerSecond());
    assertEquals("lamp", robot.getActuatorDevice(0).getName());
    assertNotNull(robot.asString());
    assertEquals(20, robot.getFramesPerSecond());
  }

  @Test
  void device_onNoAgent_saysSo() {
    RangeSensorBelt belt =
        new RangeSensorBelt(0.3f, 0, 1, 4, RangeSensorBelt.TYPE_SONAR, 0) {
          @Override
          protected void update() {
            getOwner();
          }

          void updateNow() {
            update();
          }

          @Override
          public String getName() {
            updateNow();
            return super.getName();
          }
        };
    assertThrows(IllegalStateException.class, belt::getName);
  }

  @Test
  void staticObject_withoutShapes_isNotThere() {
    Agent robot = robotAt(0, 0);
    BaseObject nothing = new StaticObject();
    environment.add(nothing);
    robot.setTranslationalVelocity(0.5);
    Simbatch simulation = new Simbatch(environment, false);
    step(simulation, 2);
    assertFalse(robot.collisionDetected());
  }
}
