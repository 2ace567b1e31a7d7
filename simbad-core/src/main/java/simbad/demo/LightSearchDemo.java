package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.LampActuator;
import simbad.sim.LightSensor;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** A robot turns to the side that is brighter, goes round boxes, and blinks under the lamp. */
public class LightSearchDemo extends Demo {
  /** Where the lamp hangs: x, y and z in metres. */
  static final double[] LAMP = {4, 1.5, -3.5};

  final Robot robot;

  /** Creates the environment. */
  public LightSearchDemo() {
    addSquareOfWalls(14);
    light1SetPosition(LAMP[0], LAMP[1], LAMP[2]);
    ambientLightColor = darkgray;
    add(new Box(new Vector3d(0, 0, 0.5), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(1.5, 0, -2.5), new Vector3f(1, 1, 1), this));
    robot = new Robot();
    add(robot);
  }

  /** Two light sensors, and sonars for what stands in the way. */
  static final class Robot extends Agent {
    private static final double BRIGHT_LX = 0.085;
    private static final double WAY_M = 0.6;

    final LampActuator lamp = RobotFactory.addLamp(this);
    private final LightSensor left = RobotFactory.addLightSensorLeft(this);
    private final LightSensor right = RobotFactory.addLightSensorRight(this);
    private final RangeSensorBelt sonars = RobotFactory.addSonarBeltSensor(this, 16);
    private final Avoidance avoidance = new Avoidance(this, sonars, 0.5);
    private int avoiding;

    Robot() {
      super(new Vector3d(-4.5, 0, 4), "light seeker");
    }

    @Override
    public void initBehavior() {
      avoiding = 0;
      lamp.setOn(false);
    }

    @Override
    public void performBehavior() {
      double brightLx = (left.getLux() + right.getLux()) / 2;
      boolean there = brightLx > BRIGHT_LX;
      lamp.setOn(there);
      lamp.setBlink(there);
      avoiding = isBlocked() ? 30 : Math.max(0, avoiding - 1);
      if (there) {
        setTranslationalVelocity(0);
        setRotationalVelocity(0);
      } else if (avoiding > 0) {
        avoidance.steer();
      } else {
        setTranslationalVelocity(0.5);
        setRotationalVelocity(4 * (left.getLux() - right.getLux()) / brightLx);
      }
    }

    private boolean isBlocked() {
      for (int i = 0; i < sonars.getNumSensors(); i++) {
        boolean ahead = i <= 3 || i >= sonars.getNumSensors() - 3;
        if (ahead && sonars.hasHit(i) && sonars.getMeasurement(i) < WAY_M) {
          return true;
        }
      }
      return collisionDetected();
    }
  }
}
