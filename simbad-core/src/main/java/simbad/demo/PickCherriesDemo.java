package simbad.demo;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sim.CherryAgent;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/**
 * A robot looks for cherries and picks them up. Its upper belt sees walls; its lower belt sees
 * walls and cherries: what only the lower one sees is a cherry.
 */
public class PickCherriesDemo extends Demo {
  private static final float CHERRY_M = 0.15f;

  final Robot robot;
  final List<CherryAgent> cherries = new ArrayList<>();

  /** Creates the environment. */
  public PickCherriesDemo() {
    addSquareOfWalls(10);
    for (int i = 0; i < 12; i++) {
      // A sunflower's pattern: evenly spread, in no row.
      double angle = i * Math.PI * (3 - Math.sqrt(5));
      double radius = 1.2 * Math.sqrt(i + 1.0);
      CherryAgent cherry =
          new CherryAgent(
              new Vector3d(radius * Math.cos(angle), 0, radius * Math.sin(angle)),
              "cherry " + (i + 1),
              CHERRY_M);
      cherries.add(cherry);
      add(cherry);
    }
    robot = new Robot(new Vector3d(-4, 0, -4), "picker");
    add(robot);
  }

  /** Drives to the nearest cherry that it sees, else looks round. */
  public class Robot extends Agent {
    private static final int RAYS = 36;

    int picked;
    private final RangeSensorBelt upper;
    private final RangeSensorBelt lower;
    private final Avoidance avoidance;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      upper = RobotFactory.addSonarBeltSensor(this, RAYS, 2.5f);
      upper.setUpdateOnEachFrame(true);
      lower = new RangeSensorBelt(getRadius(), 0, 2.5f, RAYS, RangeSensorBelt.TYPE_IR, 0);
      lower.setUpdateOnEachFrame(true);
      addSensorDevice(lower, new Vector3d(0, CHERRY_M - getHeight() / 2, 0), 0);
      avoidance = new Avoidance(this, upper, 0.6);
    }

    /** Has picked nothing yet; cherries of a former run are back. */
    @Override
    public void initBehavior() {
      picked = 0;
      cherries.forEach(CherryAgent::attach);
    }

    /** Picks what is near, and drives. */
    @Override
    public void performBehavior() {
      SimpleAgent near = getVeryNearAgent();
      if (near instanceof CherryAgent) {
        near.detach();
        picked++;
      }
      int cherry = nearestCherry();
      if (cherry < 0) {
        avoidance.steer();
      } else {
        double angle = Math.IEEEremainder(lower.getSensorAngle(cherry), 2 * Math.PI);
        setRotationalVelocity(2 * angle);
        setTranslationalVelocity(0.6 * Math.max(0, Math.cos(angle)));
      }
    }

    /** Returns the ray that hits the nearest cherry, -1 if none does. */
    private int nearestCherry() {
      int nearest = -1;
      for (int i = 0; i < RAYS; i++) {
        double margin = upper.getMeasurement(i) - lower.getMeasurement(i);
        boolean cherry = lower.hasHit(i) && margin > CHERRY_M;
        if (cherry && (nearest < 0 || lower.getMeasurement(i) < lower.getMeasurement(nearest))) {
          nearest = i;
        }
      }
      return nearest;
    }
  }
}
