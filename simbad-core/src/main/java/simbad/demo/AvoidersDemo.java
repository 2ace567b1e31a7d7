package simbad.demo;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.RobotFactory;

/** Eight robots that keep clear of walls, of boxes and of each other. */
public class AvoidersDemo extends Demo {
  private static final int ROBOTS = 8;
  private static final double RING_M = 3;

  final List<Robot> robots = new ArrayList<>();

  /** Creates the environment. */
  public AvoidersDemo() {
    addSquareOfWalls(12);
    add(new Box(new Vector3d(), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(4, 0, -4), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(-4, 0, 4), new Vector3f(1, 1, 1), this));
    for (int i = 0; i < ROBOTS; i++) {
      double angle = i * 2 * Math.PI / ROBOTS;
      Vector3d start = new Vector3d(RING_M * Math.cos(angle), 0, -RING_M * Math.sin(angle));
      Robot robot = new Robot(start, "avoider " + (i + 1));
      robot.setColor(new Color3f((float) i / ROBOTS, 0.8f - 0.6f * i / ROBOTS, 0.4f));
      robot.startHeadingRad = 1.9 * i;
      robots.add(robot);
      add(robot);
    }
  }

  /** Keeps clear of what its sonars see, others included. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private final Avoidance avoidance;
    private double startHeadingRad;

    /** Creates a robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      avoidance = new Avoidance(this, RobotFactory.addSonarBeltSensor(this, 16), 0.5);
    }

    /** Starts in a direction of its own. */
    @Override
    public void initBehavior() {
      rotateY(startHeadingRad);
    }

    /** Drives on. */
    @Override
    public void performBehavior() {
      avoidance.steer();
    }
  }
}
