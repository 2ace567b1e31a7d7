package simbad.demo;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Box;
import simbad.sim.KheperaRobot;
import simbad.sim.RangeSensorBelt;

/** A Khepera in a maze of a table's size: infrared on the one side slows the wheel on the other. */
public class KheperaDemo extends Demo {
  /** Half the side of the table, metres. */
  static final double HALF_M = 0.4;

  private static final float EDGE_M = 0.02f;
  private static final float HEIGHT_M = 0.05f;

  final Robot robot;

  /** Creates the environment. */
  public KheperaDemo() {
    setWorldSize(1);
    float side = (float) (2 * HALF_M) + EDGE_M;
    addBlock(0, HALF_M, side, EDGE_M);
    addBlock(0, -HALF_M, side, EDGE_M);
    addBlock(HALF_M, 0, EDGE_M, side);
    addBlock(-HALF_M, 0, EDGE_M, side);
    addBlock(-0.1, 0.12, 0.25f, EDGE_M);
    addBlock(0.15, -0.1, EDGE_M, 0.3f);
    addBlock(-0.2, -0.2, 0.08f, 0.08f);
    robot = new Robot(new Vector3d(-0.3, 0, 0), "khepera");
    add(robot);
  }

  private void addBlock(double xM, double zM, float widthM, float depthM) {
    add(new Box(new Vector3d(xM, 0, zM), new Vector3f(widthM, HEIGHT_M, depthM), this));
  }

  /** Couples infrared and wheels, in the manner of Braitenberg's vehicles. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends KheperaRobot {
    private static final double CRUISE_M_PER_S = 0.05;

    /** By how much a sensor that touches changes the wheels, by sensor from left to right. */
    private static final double[] LEFT_WHEEL = {0.4, 0.8, 1.2, -2.2, -1.4, -0.8};

    private static final double[] RIGHT_WHEEL = {-0.8, -1.4, -2.0, 0.8, 0.8, 0.4};

    private int backing;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      getIRSensors().setUpdateOnEachFrame(true);
    }

    /** Starts at an angle to the walls. */
    @Override
    public void initBehavior() {
      backing = 0;
      rotateY(0.3);
    }

    /** Sets the wheels. */
    @Override
    public void performBehavior() {
      if (collisionDetected()) {
        backing = 20;
      }
      if (backing > 0) {
        backing--;
        setWheelsVelocity(-CRUISE_M_PER_S, -CRUISE_M_PER_S / 2);
      } else {
        setWheelsVelocity(speed(LEFT_WHEEL), speed(RIGHT_WHEEL));
      }
    }

    private double speed(double[] weights) {
      RangeSensorBelt infrared = getIRSensors();
      double share = 1;
      for (int i = 0; i < weights.length; i++) {
        double nearness = 1 - infrared.getMeasurement(i) / infrared.getMaxRange();
        share += infrared.hasHit(i) ? weights[i] * nearness : 0;
      }
      return CRUISE_M_PER_S * Math.max(-1, Math.min(1.5, share));
    }
  }
}
