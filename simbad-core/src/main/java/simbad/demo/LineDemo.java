package simbad.demo;

import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sim.Line;
import simbad.sim.LineSensor;
import simbad.sim.RobotFactory;

/** A robot follows a line round a course with six corners, left ones and a right one. */
public class LineDemo extends Demo {
  /** Corners of the course: x and z in turn, metres. */
  static final double[] COURSE = {-4, -3, -4, 3, 0, 3, 0, 0, 4, 0, 4, -3};

  final Robot robot;

  /** Creates the environment. */
  public LineDemo() {
    setWorldSize(11);
    for (int i = 0; i < COURSE.length; i += 2) {
      int next = (i + 2) % COURSE.length;
      addLine(COURSE[i], COURSE[i + 1], COURSE[next], COURSE[next + 1]);
    }
    robot = new Robot(new Vector3d(2, 0, -3), "line follower");
    add(robot);
  }

  /** Lines run along +z until they are turned by quarters. */
  private void addLine(double fromX, double fromZ, double toX, double toZ) {
    int quarters = toX > fromX ? 1 : toX < fromX ? 3 : toZ < fromZ ? 2 : 0;
    double length = Math.abs(toX - fromX) + Math.abs(toZ - fromZ);
    Line line = new Line(new Vector3d(fromX, 0, fromZ), (float) length, this);
    line.rotate90(quarters);
    add(line);
  }

  /** Steers towards the middle of what its rays hit; without a hit, to where the line was last. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private static final double TURN_RAD_PER_S = 1.2;

    final LineSensor sensor;
    private double lastSide;

    /** Creates the robot where its base shall stand. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      sensor = RobotFactory.addLineSensor(this, 11);
    }

    /** Looks along the line, towards -x. */
    @Override
    public void initBehavior() {
      lastSide = 1;
      rotateY(Math.PI);
    }

    /** Steers. */
    @Override
    public void performBehavior() {
      double side = 0;
      int hits = 0;
      for (int i = 0; i < sensor.getNumSensors(); i++) {
        if (sensor.hasHit(i)) {
          side += 1 - 2.0 * i / (sensor.getNumSensors() - 1);
          hits++;
        }
      }
      if (hits == 0) {
        setTranslationalVelocity(0);
        setRotationalVelocity(lastSide * TURN_RAD_PER_S);
        return;
      }
      double mean = side / hits;
      lastSide = Math.abs(mean) > 0.3 ? Math.signum(mean) : lastSide;
      setTranslationalVelocity(0.4 * (1 - 0.6 * Math.abs(mean)));
      setRotationalVelocity(mean * TURN_RAD_PER_S);
    }
  }
}
