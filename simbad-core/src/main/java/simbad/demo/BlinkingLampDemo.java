package simbad.demo;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.LampActuator;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** Robots whose lamps shine, and blink while something is near. */
public class BlinkingLampDemo extends Demo {
  final List<Robot> robots = new ArrayList<>();

  /** Creates the environment. */
  public BlinkingLampDemo() {
    addSquareOfWalls(12);
    add(new Box(new Vector3d(0, 0, 3), new Vector3f(1, 1, 1), this));
    for (int i = 0; i < 3; i++) {
      Robot robot = new Robot(new Vector3d(2.5 * i - 2.5, 0, -2), "lamp " + (i + 1));
      robots.add(robot);
      add(robot);
    }
  }

  /** Warns with its lamp. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    static final double NEAR_M = 0.8;

    final RangeSensorBelt sonars;
    final LampActuator lamp;
    private final Avoidance avoidance;

    /** Creates a robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      lamp = RobotFactory.addLamp(this);
      sonars = RobotFactory.addSonarBeltSensor(this, 12);
      avoidance = new Avoidance(this, sonars, 0.4);
    }

    /** Lights the lamp. */
    @Override
    public void initBehavior() {
      lamp.setOn(true);
      lamp.setBlink(false);
      rotateY(Math.PI / 2);
    }

    /** Drives on, and blinks at what is near. */
    @Override
    public void performBehavior() {
      lamp.setBlink(isSomethingNear());
      avoidance.steer();
    }

    private boolean isSomethingNear() {
      for (int i = 0; i < sonars.getNumSensors(); i++) {
        if (sonars.hasHit(i) && sonars.getMeasurement(i) < NEAR_M) {
          return true;
        }
      }
      return false;
    }
  }
}
