package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.BallAgent;
import simbad.sim.Box;
import simbad.sim.CameraSensor;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.KinematicModel;
import simbad.sim.Line;
import simbad.sim.LineSensor;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/** What a second comparison with the original found, where no recorded trace shows it. */
class SecondComparisonTest {
  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final List<Line> lines = new ArrayList<>();

  private <T extends SimpleAgent> T add(T agent) {
    environment.add(agent);
    return agent;
  }

  private Agent robot() {
    return add(new Agent(new Vector3d(), "robot"));
  }

  private void box(double x, double width) {
    environment.add(new Box(new Vector3d(x, 0, 0), new Vector3f((float) width, 2, 4), environment));
  }

  private Simbatch run(int steps) {
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
    return simulation;
  }

  private static Point3d at(SimpleAgent agent) {
    Point3d at = new Point3d();
    agent.getCoords(at);
    return at;
  }

  /** A camera is blind at a gap of 0.09 m before the body, and sees at one of 0.12 m. */
  @ParameterizedTest
  @CsvSource({"0.09, false", "0.12, true"})
  void camera_seesNothingNearerThanFourDecimetres(double gap, boolean seen) {
    Agent robot = robot();
    box(0.3 + gap + 0.5, 1);
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    run(1).dispose();
    BufferedImage image = camera.createCompatibleImage();
    camera.copyVisionImage(image);
    int middle = image.getRGB(image.getWidth() / 2, image.getHeight() / 2);
    boolean red = (middle >> 16 & 0xff) > (middle >> 8 & 0xff) + 20;
    assertEquals(seen, red);
  }

  /** A robot of 0.25 m and a range of 1.5 m: the ray ends at x = 1.75, an exact number. */
  @ParameterizedTest
  @CsvSource({"1.75, true", "1.7501, false"})
  void ray_thatEndsAtASurface_isAHit(double face, boolean hit) {
    Agent robot =
        add(
            new Agent(new Vector3d(), "robot") {
              {
                radius = 0.25f;
              }
            });
    RangeSensorBelt belt = RobotFactory.addSonarBeltSensor(robot, 1);
    box(face + 0.5, 1);
    run(1).dispose();
    assertEquals(hit, belt.hasHit(0));
  }

  @Test
  void kinematicsThatSink_endAtTheFloor() {
    Agent robot =
        add(
            new Agent(new Vector3d(0, 1, 0), "robot") {
              {
                setKinematicModel(new Sinking());
              }
            });
    run(60).dispose();
    assertEquals(0.25, at(robot).y, 1e-6);
    assertEquals(3, at(robot).x, 1e-6);
  }

  private static final class Sinking extends KinematicModel {
    @Override
    protected void update(
        double elapsedSecond,
        javax.media.j3d.Transform3D rotation,
        Vector3d translation,
        Vector3d turn) {
      translation.set(elapsedSecond, -elapsedSecond, 0);
    }

    @Override
    protected void reset() {}

    @Override
    protected String toString(java.text.DecimalFormat format) {
      return "";
    }
  }

  /** A ball that flies, of friction 0.1: it keeps its speed, or loses it as if it rolled. */
  @Test
  void friction_actsOnTheFloor_andInTheAirIfSwitched() {
    environment.setUsePhysics(true);
    assertEquals(1, speedInTheAir(), 1e-9);
    environment.compatibility.add(Compatibility.FRICTION_IN_THE_AIR);
    assertTrue(speedInTheAir() < 0.99);
  }

  private double speedInTheAir() {
    Flying ball = new Flying();
    EnvironmentDescription own = new EnvironmentDescription();
    own.setUsePhysics(true);
    own.compatibility.addAll(environment.compatibility);
    own.add(ball);
    Simbatch simulation = new Simbatch(own, false);
    simulation.reset();
    for (int i = 0; i < 5; i++) {
      simulation.step();
    }
    assertTrue(at(ball).y > 3);
    return ball.alongX();
  }

  private static final class Flying extends BallAgent {
    Flying() {
      super(new Vector3d(0, 5, 0), "ball", 0.2f);
    }

    @Override
    protected void initBehavior() {
      linearVelocity.x = 1;
    }

    double alongX() {
      return linearVelocity.x;
    }
  }

  /** Sixty episodes of odd lengths; in the first step of each, both belts sense the box. */
  @Test
  void resets_letBeltsSenseInTheFirstStep() {
    Agent robot = robot();
    RangeSensorBelt sonars = RobotFactory.addSonarBeltSensor(robot, 8);
    RangeSensorBelt bumpers = RobotFactory.addBumperBeltSensor(robot, 8);
    box(0.36 + 0.5, 1);
    Simbatch simulation = new Simbatch(environment, false);
    for (int episode = 0; episode < 60; episode++) {
      simulation.reset();
      assertFalse(sonars.oneHasHit() || bumpers.oneHasHit());
      simulation.step();
      assertTrue(sonars.hasHit(0) && bumpers.hasHit(0), "episode " + episode);
      for (int i = 0; i < episode % 17; i++) {
        simulation.step();
      }
    }
  }

  /** Wherever a line is turned to, it begins where it began. */
  @ParameterizedTest
  @ValueSource(ints = {-1, 0, 1, 2, 3, 4, 5})
  void line_turnsAboutItsStart(int quarters) {
    Line line = new Line(new Vector3d(1, 0, 2), 3, environment);
    line.rotate90(quarters);
    Line twice = new Line(new Vector3d(10, 0, 2), 3, environment);
    twice.rotate90(quarters - 1);
    twice.rotate90(1);
    lines.addAll(List.of(line, twice));
    double angle = quarters * Math.PI / 2;
    for (double along : List.of(0.1, 2.9)) {
      assertEquals(
          List.of(true, true),
          List.of(
              isLineAt(1 + along * Math.sin(angle), 2 + along * Math.cos(angle)),
              isLineAt(10 + along * Math.sin(angle), 2 + along * Math.cos(angle))),
          "at " + along);
      assertFalse(isLineAt(1 - along * Math.sin(angle), 2 - along * Math.cos(angle)));
    }
  }

  private boolean isLineAt(double x, double z) {
    EnvironmentDescription own = new EnvironmentDescription();
    lines.forEach(own::add);
    List<LineSensor> sensors = new ArrayList<>();
    own.add(
        new Agent(new Vector3d(x - 0.301, 0, z), "robot") {
          {
            sensors.add(RobotFactory.addLineSensor(this, 1));
          }
        });
    Simbatch simulation = new Simbatch(own, false);
    simulation.reset();
    simulation.step();
    return sensors.get(0).hasHit(0);
  }
}
