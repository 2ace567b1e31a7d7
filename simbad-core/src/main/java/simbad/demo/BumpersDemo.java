package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** A robot with nothing but bumpers: it feels its way, backs off and turns to the other side. */
public class BumpersDemo extends Demo {
  final Robot robot;

  /** Creates the environment. */
  public BumpersDemo() {
    addSquareOfWalls(8);
    add(new Box(new Vector3d(2, 0, 0.2), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(-2, 0, -1.5), new Vector3f(1, 1, 2), this));
    robot = new Robot(new Vector3d(), "robot");
    add(robot);
  }

  /** Turns to the side whose bumpers do not touch. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private static final int BACK_STEPS = 12;
    private static final int TURN_STEPS = 17;

    private final RangeSensorBelt bumpers;
    private int reaction;
    private int side = 1;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      bumpers = RobotFactory.addBumperBeltSensor(this, 12);
      bumpers.setUpdateOnEachFrame(true);
    }

    /** Forgets what it has run into. */
    @Override
    public void initBehavior() {
      reaction = 0;
    }

    /** Drives on, backs off, or turns. */
    @Override
    public void performBehavior() {
      if (reaction == 0 && (collisionDetected() || bumpers.getFrontQuadrantHits() > 0)) {
        reaction = BACK_STEPS + TURN_STEPS;
        side = leftTouches() ? -1 : 1;
      }
      if (reaction == 0) {
        setTranslationalVelocity(0.5);
        setRotationalVelocity(0);
      } else {
        boolean back = reaction > TURN_STEPS;
        setTranslationalVelocity(back ? -0.3 : 0);
        setRotationalVelocity(back ? 0 : side * 1.6);
        reaction--;
      }
    }

    private boolean leftTouches() {
      return bumpers.getFrontLeftQuadrantHits() > bumpers.getFrontRightQuadrantHits();
    }
  }
}
