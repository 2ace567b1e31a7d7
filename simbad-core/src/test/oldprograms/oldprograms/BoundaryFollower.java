package oldprograms;

import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** The course recipe: nearest ray as a point, tangent direction, speed by the cosine. */
public class BoundaryFollower extends EnvironmentDescription {
  static final double WANTED = 0.8;
  public MyRobot robot;

  public BoundaryFollower() {
    add(new Box(new Vector3d(0, 0, 0), new Vector3f(2, 1, 2), this));
    add(robot = new MyRobot(new Vector3d(0, 0, 1.9), "follower"));
  }

  public class MyRobot extends Agent {
    RangeSensorBelt sonars;
    public double nearest = Double.NaN;

    public MyRobot(Vector3d position, String name) {
      super(position, name);
      sonars = RobotFactory.addSonarBeltSensor(this, 24, 1.5f);
      sonars.setUpdatePerSecond(60);
    }

    Point3d pointOf(int i) {
      double v = sonars.hasHit(i) ? radius + sonars.getMeasurement(i) : radius + sonars.getMaxRange();
      return new Point3d(v * Math.cos(sonars.getSensorAngle(i)), 0, v * Math.sin(sonars.getSensorAngle(i)));
    }

    public void performBehavior() {
      int min = 0;
      for (int i = 1; i < sonars.getNumSensors(); i++) {
        if (sonars.getMeasurement(i) < sonars.getMeasurement(min)) min = i;
      }
      Point3d p = pointOf(min);
      nearest = p.distance(new Point3d());
      // The obstacle stays on the left.
      Vector3d tangent = new Vector3d(p.z, 0, -p.x);
      double phi = Math.atan2(tangent.z, tangent.x) + Math.atan(3 * (nearest - WANTED));
      while (phi > Math.PI) phi -= 2 * Math.PI;
      while (phi < -Math.PI) phi += 2 * Math.PI;
      setRotationalVelocity(3 * phi);
      setTranslationalVelocity(0.5 * Math.cos(phi));
    }
  }

  public static void main(String[] args) {
    new Simbad(new BoundaryFollower(), false);
  }
}
