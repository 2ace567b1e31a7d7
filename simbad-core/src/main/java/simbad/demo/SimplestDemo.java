package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Arch;
import simbad.sim.Box;

/** A robot without sensors: it drives on, and turns away from what it has run into. */
public class SimplestDemo extends Demo {
  final Robot robot;

  /** Creates the environment. */
  public SimplestDemo() {
    addSquareOfWalls(10);
    add(new Box(new Vector3d(3, 0, 1), new Vector3f(1, 1, 1), this));
    add(new Arch(new Vector3d(-2, 0, -2), this));
    robot = new Robot(new Vector3d(0, 0, 0), "robot");
    add(robot);
  }

  /** Needs nothing but its collision flag. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private static final int TURN_STEPS = 23;
    private int turning;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
    }

    /** Drives off. */
    @Override
    public void initBehavior() {
      turning = 0;
    }

    /** Drives on, or turns by 99 degrees. */
    @Override
    public void performBehavior() {
      if (collisionDetected()) {
        turning = TURN_STEPS;
      }
      setTranslationalVelocity(turning > 0 ? 0 : 0.5);
      setRotationalVelocity(turning > 0 ? 1.5 : 0);
      turning = Math.max(0, turning - 1);
    }
  }
}
