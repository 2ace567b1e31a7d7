package simbad.gui;

import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;

/** An example of a run without a window: one robot, a thousand steps. */
public class TestSimbatch extends EnvironmentDescription {
  private static final int STEPS = 1000;

  private final MyRobot robot = new MyRobot(new Vector3d(), "my robot");

  /** Creates a world with one robot. */
  @SuppressWarnings("this-escape")
  public TestSimbatch() {
    add(robot);
  }

  /** Runs the example. */
  public static void main(String[] args) {
    new TestSimbatch().run();
  }

  /** Does the steps and returns how far the robot has gone, metres. */
  double run() {
    Simbatch batch = new Simbatch(this, false);
    batch.reset();
    for (int i = 0; i < STEPS; i++) {
      batch.step();
    }
    batch.dispose();
    return robot.getOdometer();
  }

  /** Drives in a circle. */
  @SuppressWarnings("ClassCanBeStatic") // Its constructor is Simbad's.
  public class MyRobot extends Agent {
    /** Creates a robot at a position, metres. */
    public MyRobot(Vector3d position, String name) {
      super(position, name);
    }

    @Override
    public void initBehavior() {
      setTranslationalVelocity(0.5);
      setRotationalVelocity(0.5);
    }

    @Override
    public void performBehavior() {
      // The velocities hold until they are changed.
    }
  }
}
