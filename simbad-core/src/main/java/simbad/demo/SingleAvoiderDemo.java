package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.RobotFactory;

/** One robot finds its way through a field of boxes. */
public class SingleAvoiderDemo extends Demo {
  private static final double PITCH_M = 2.6;

  final Robot robot;

  /** Creates the environment. */
  public SingleAvoiderDemo() {
    addSquareOfWalls(12);
    for (int column = -1; column <= 1; column++) {
      for (int row = -1; row <= 1; row++) {
        add(
            new Box(
                new Vector3d(column * PITCH_M + 0.4 * row, 0, row * PITCH_M),
                new Vector3f(0.6f, 0.7f, 0.6f),
                this));
      }
    }
    robot = new Robot(new Vector3d(-4.5, 0, -4), "avoider");
    add(robot);
  }

  /** Looks all round with 24 sonars, in every step. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private final Avoidance avoidance;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      var sonars = RobotFactory.addSonarBeltSensor(this, 24, 1);
      sonars.setUpdateOnEachFrame(true);
      avoidance = new Avoidance(this, sonars, 0.6);
    }

    /** Starts across the field. */
    @Override
    public void initBehavior() {
      rotateY(-0.3);
    }

    /** Drives on. */
    @Override
    public void performBehavior() {
      avoidance.steer();
    }
  }
}
