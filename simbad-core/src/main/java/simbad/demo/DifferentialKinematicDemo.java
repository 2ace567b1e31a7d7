package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.DifferentialKinematic;
import simbad.sim.RobotFactory;

/** A robot on two driven wheels draws figures of eight round two boxes. */
public class DifferentialKinematicDemo extends Demo {
  /** Steps of one loop of the eight. */
  static final int LOOP_STEPS = 250;

  final Robot robot;

  /** Creates the environment. */
  public DifferentialKinematicDemo() {
    setWorldSize(8);
    double radiusM = Robot.SPEED_M_PER_S * LOOP_STEPS * Robot.STEP_S / (2 * Math.PI);
    for (int side = -1; side <= 1; side += 2) {
      add(new Box(new Vector3d(0, 0, side * radiusM), new Vector3f(0.5f, 0.5f, 0.5f), this));
    }
    robot = new Robot(new Vector3d(), "two wheels");
    add(robot);
  }

  /** Sets the speeds of its wheels: one loop to the left, one to the right. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    static final double SPEED_M_PER_S = 0.6;
    static final double STEP_S = 0.05;

    private final DifferentialKinematic wheels;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      wheels = RobotFactory.setDifferentialDriveKinematicModel(this);
    }

    /** Stands still. */
    @Override
    public void initBehavior() {
      wheels.setWheelsVelocity(0, 0);
    }

    /** Lets the outer wheel turn faster. The wheels' distance is the robot's radius. */
    @Override
    public void performBehavior() {
      double turnRadPerS = 2 * Math.PI / (LOOP_STEPS * STEP_S);
      double half = turnRadPerS * getRadius() / 2;
      double side = getCounter() / LOOP_STEPS % 2 == 0 ? 1 : -1;
      wheels.setWheelsVelocity(SPEED_M_PER_S - side * half, SPEED_M_PER_S + side * half);
    }
  }
}
