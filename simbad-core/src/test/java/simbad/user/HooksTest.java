package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.text.DecimalFormat;
import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.media.j3d.Bounds;
import javax.media.j3d.Transform3D;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.PrismShape;
import simbad.kernel.geometry.Ray;
import simbad.kernel.geometry.Shape;
import simbad.sim.Agent;
import simbad.sim.BlockWorldObject;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.KinematicModel;
import simbad.sim.PickSensor;
import simbad.sim.RangeSensorBelt;
import simbad.sim.StaticObject;
import simbad.sim.World;
import simbad.sonar.sensing.Sensor;

/** What programs in other packages may override, and in which order they are called. */
class HooksTest {
  private static final double EPSILON = 1e-9;

  private final EnvironmentDescription environment = new EnvironmentDescription();

  private Simbatch start() {
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    return simulation;
  }

  /** Notes the stations of a step. */
  private static final class Diary extends Agent {
    private final List<String> entries = new ArrayList<>();

    Diary() {
      super(new Vector3d(), "diary");
    }

    @Override
    protected void create() {
      entries.add("create");
      super.create();
    }

    @Override
    protected void initBehavior() {
      entries.add("initBehavior");
    }

    @Override
    protected void performPreBehavior() {
      entries.add("performPreBehavior");
      super.performPreBehavior();
    }

    @Override
    protected void performBehavior() {
      entries.add("performBehavior");
    }

    @Override
    protected void setMotorsAcceleration(double elapsedSecond) {
      entries.add("setMotorsAcceleration");
      super.setMotorsAcceleration(elapsedSecond);
    }

    @Override
    protected void updatePosition() {
      entries.add("updatePosition");
      super.updatePosition();
    }

    @Override
    protected void updateCounters(double elapsedSecond) {
      entries.add("updateCounters");
      super.updateCounters(elapsedSecond);
    }
  }

  @Test
  void step_callsTheHooksInOrder() {
    Diary diary = new Diary();
    environment.add(diary);
    start().step();
    assertEquals(
        List.of(
            "create",
            "initBehavior",
            "performPreBehavior",
            "performBehavior",
            "setMotorsAcceleration",
            "updatePosition",
            "updateCounters"),
        diary.entries);
  }

  /** Goes sideways, which no wheel does. */
  private static final class Crab extends KinematicModel {
    @Override
    protected void update(
        double elapsedSecond, Transform3D rotation, Vector3d translation, Vector3d turn) {
      translation.set(0, 0, elapsedSecond);
      turn.set(0, 0, 0);
    }

    @Override
    protected void reset() {
      // Nothing to stop.
    }

    @Override
    protected String toString(DecimalFormat format) {
      return "crab";
    }
  }

  @Test
  void kinematicModel_ofTheUser_moves() {
    Agent agent =
        new Agent(new Vector3d(), "crab") {
          @Override
          protected void create() {
            super.create();
            setKinematicModel(new Crab());
          }
        };
    environment.add(agent);
    Simbatch simulation = start();
    for (int i = 0; i < 20; i++) {
      simulation.step();
    }
    Point3d coords = new Point3d();
    agent.getCoords(coords);
    assertEquals(1, coords.z, EPSILON);
    assertEquals(1, agent.getOdometer(), EPSILON);
    assertEquals(1, agent.getLifeTime(), EPSILON);
    assertEquals(0, agent.getTranslationalVelocity());
    agent.setTranslationalVelocity(1);
    assertEquals(0, agent.getTranslationalVelocity());
  }

  /** An obstacle whose body is a prism over an angle profile. */
  private static final class AngleProfile extends BlockWorldObject {
    AngleProfile(double x, double z) {
      translateTo(new Vector3d(x, 0, z));
    }

    @Override
    protected List<Shape> bodyShapes() {
      return List.of(
          new PrismShape(
              new double[] {0, 1, 1, 0.1, 0.1, 0}, new double[] {0, 0, 0.1, 0.1, 1, 1}, 0, 1));
    }
  }

  /** A belt that hears each transducer's own height and keeps the time. */
  private static final class OddBelt extends RangeSensorBelt {
    private final List<World> worlds = new ArrayList<>();
    private final List<Double> pings = new ArrayList<>();

    OddBelt() {
      super(0.1f, 0, 9, 3, TYPE_SONAR, FLAG_RETURN_INFINITY);
      setUpdateOnEachFrame(true);
    }

    @Override
    protected Sensor createSensor(World world) {
      worlds.add(world);
      return (poses, timeS, readings) -> {
        pings.add(timeS);
        readings.clear();
        readings.setEcho(0, poses.yM(0));
        readings.setEcho(1, poses.headingRad(1));
      };
    }
  }

  /** A robot with a belt of the user's. */
  private static final class Carrier extends Agent {
    Carrier(RangeSensorBelt belt) {
      super(new Vector3d(), "carrier");
      addSensorDevice(belt, new Vector3d(0, 0.1, 0), 0);
    }
  }

  @Test
  void sensor_ofTheUser_isAskedWithPosesAndTime() {
    OddBelt belt = new OddBelt();
    environment.add(new Carrier(belt));
    environment.add(new AngleProfile(1, 1));
    Simbatch simulation = start();
    simulation.step();
    simulation.step();
    assertEquals(1, belt.worlds.size());
    assertEquals(List.of(0.0, 0.05), belt.pings);
    assertEquals(0.35, belt.getMeasurement(0), EPSILON);
    assertEquals(2 * Math.PI / 3, belt.getMeasurement(1), EPSILON);
    assertEquals(Double.POSITIVE_INFINITY, belt.getMeasurement(2));
    assertTrue(belt.getReadings().isEcho(1));
    assertEquals(1, belt.worlds.get(0).getStaticObjects().size());
  }

  @Test
  void world_tellsWhenStaticObjectsChange() {
    AngleProfile profile = new AngleProfile(1, 1);
    environment.add(profile);
    World world = new World(environment);
    final long before = world.getStaticRevision();
    profile.rotateY(1);
    assertTrue(world.getStaticRevision() > before);
    final long turned = world.getStaticRevision();
    world.detach(profile);
    assertFalse(world.getStaticObjects().get(0).getSolid().isPresent());
    assertTrue(world.getStaticRevision() > turned);
    world.attach(profile);
    assertTrue(profile.getSolid().isPresent());
    world.dispose();
  }

  @Test
  void prism_ofTheUser_isSeenAndStops() {
    RangeSensorBelt belt = new RangeSensorBelt(0.3f, 0, 2, 4, RangeSensorBelt.TYPE_SONAR, 0);
    belt.setUpdateOnEachFrame(true);
    Agent robot = new Carrier(belt);
    environment.add(robot);
    // Its outer corner is at (1, -0.5): the long leg crosses the robot's way.
    environment.add(new AngleProfile(1, -0.5));
    Simbatch simulation = start();
    simulation.step();
    assertEquals(0.7, belt.getMeasurement(0), 1e-6);
    robot.setTranslationalVelocity(1);
    for (int i = 0; i < 30; i++) {
      simulation.step();
    }
    assertTrue(robot.collisionDetected());
    assertEquals(0.65, robot.getOdometer(), EPSILON);
  }

  /** A box that lets everyone in from the left. */
  private static final class Curtain extends Box {
    Curtain(EnvironmentDescription environment) {
      super(new Vector3d(1, 0, 0), new Vector3f(0.2f, 1, 1), environment);
    }

    @Override
    protected boolean intersect(BoundingSphere bounds) {
      return false;
    }

    Bounds boundsNow() {
      createLocalToVworld();
      return getTransformedBounds();
    }

    Transform3D toWorld() {
      return localToVworld;
    }
  }

  @Test
  void intersect_ofTheUser_decides() {
    Agent robot = new Agent(new Vector3d(), "robot");
    environment.add(robot);
    Curtain curtain = new Curtain(environment);
    environment.add(curtain);
    Simbatch simulation = start();
    robot.setTranslationalVelocity(1);
    for (int i = 0; i < 40; i++) {
      simulation.step();
    }
    assertEquals(2, robot.getOdometer(), EPSILON);
    BoundingBox bounds = (BoundingBox) curtain.boundsNow();
    Point3d lower = new Point3d();
    bounds.getLower(lower);
    assertEquals(0.9, lower.x, 1e-6);
    Vector3d translation = new Vector3d();
    curtain.toWorld().get(translation);
    assertEquals(0.5, translation.y, EPSILON);
  }

  /** A sensor that looks straight down on its own. */
  private static final class Plumb extends PickSensor {
    private final Placement place = new Placement();
    private double distanceM;

    @Override
    protected void update() {
      placeInWorld(place);
      Ray ray = new Ray();
      ray.setOrigin(place.xM(), place.yM(), place.zM());
      ray.setDirection(0, -1, 0);
      ray.setLength(10);
      findWorld().ifPresent(world -> world.getScene().strike(ray, getOwner().getSolid()));
      distanceM = ray.lengthM();
    }
  }

  @Test
  void pickSensor_ofTheUser_looksAtTheScene() {
    Plumb plumb = new Plumb();
    Agent robot =
        new Agent(new Vector3d(0, 3, 0), "high") {
          @Override
          protected void create() {
            super.create();
            addSensorDevice(plumb, new Vector3d(0, 0.25, 0), 0);
          }
        };
    environment.add(robot);
    StaticObject floor = new Box(new Vector3d(), new Vector3f(4, 0.5f, 4), environment);
    environment.add(floor);
    start().step();
    assertEquals(3, plumb.distanceM, EPSILON);
    assertNotNull(plumb.getName());
  }
}
