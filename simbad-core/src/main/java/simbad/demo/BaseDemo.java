package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Arch;
import simbad.sim.Box;
import simbad.sim.RobotFactory;

/** A robot with sonars and bumpers explores a room with boxes, a wall and an arch. */
public class BaseDemo extends Demo {
  final Robot robot;

  /** Creates the environment. */
  public BaseDemo() {
    addSquareOfWalls(14);
    add(new Box(new Vector3d(4, 0, 3), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(-3, 0, 4), new Vector3f(2, 1, 1), this));
    add(new Box(new Vector3d(-4, 0, -3), new Vector3f(1, 0.8f, 3), this));
    add(new Arch(new Vector3d(3, 0, -3), this));
    robot = new Robot(new Vector3d(0, 0, 0), "robot");
    add(robot);
  }

  /** Keeps clear of what its sonars see. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private final Avoidance avoidance;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      RobotFactory.addBumperBeltSensor(this);
      avoidance = new Avoidance(this, RobotFactory.addSonarBeltSensor(this, 12), 0.6);
    }

    /** Starts to the side of the arch. */
    @Override
    public void initBehavior() {
      rotateY(Math.PI / 5);
    }

    /** Drives on. */
    @Override
    public void performBehavior() {
      avoidance.steer();
    }
  }
}
