package simbad.obstacles;

import java.util.SplittableRandom;
import javax.vecmath.Vector3d;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.StaticObject;
import simbad.sonar.model.DetectionRule;

/** A headless world with static objects and one robot of 2 cm radius that carries a belt. */
final class Bench {
  /** Sonar 0 looks along the robot's heading. */
  static final int SONARS = 12;

  final Robot robot;
  private final Simbatch simulation;

  Bench(RangeSensorBelt belt, StaticObject... objects) {
    robot = new Robot(belt);
    EnvironmentDescription environment = new EnvironmentDescription();
    for (StaticObject object : objects) {
      environment.add(object);
    }
    environment.add(robot);
    simulation = new Simbatch(environment, false);
    simulation.reset();
  }

  static SonarBelt belt(DetectionRule rule) {
    return new SonarBelt(SONARS, Catalogue.srf04(), rule, new SplittableRandom(1));
  }

  /** Puts the robot somewhere and lets it ping. */
  void ping(double x, double z, double headingRad) {
    robot.moveToPosition(x, z);
    robot.rotateY(headingRad - robot.getHeadingRad());
    simulation.step();
  }

  void reset() {
    simulation.reset();
  }

  void step() {
    simulation.step();
  }

  /** The robot. */
  static final class Robot extends Agent {
    final RangeSensorBelt belt;
    private double speed;

    Robot(RangeSensorBelt belt) {
      super(new Vector3d(50, 0, 50), "robot");
      radius = 0.02f;
      height = 0.3f;
      this.belt = belt;
      belt.setUpdateOnEachFrame(true);
      addSensorDevice(belt, new Vector3d(), 0);
    }

    void drive(double metresPerSecond) {
      speed = metresPerSecond;
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(speed);
    }
  }
}
