package oldprograms;

import javax.media.j3d.Transform3D;
import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** The goal attracts, each ray repels; the heading is read from the rotation matrix. */
public class PotentialField extends EnvironmentDescription {
  public Seeker seeker = new Seeker(new Vector3d(-4, 0, 0), "seeker", new Point3d(4, 0, 0));

  public PotentialField() {
    add(new Box(new Vector3d(0, 0, 0.4), new Vector3f(1, 1, 1), this));
    add(seeker);
  }

  public static class Seeker extends Agent {
    private final Point3d goal;
    private final RangeSensorBelt sonars;

    public Seeker(Vector3d position, String name, Point3d goal) {
      super(position, name);
      this.goal = goal;
      sonars = RobotFactory.addSonarBeltSensor(this, 12);
      sonars.setUpdateOnEachFrame(true);
    }

    public double distance() {
      Point3d here = new Point3d();
      getCoords(here);
      here.y = 0;
      return here.distance(goal);
    }

    double heading() {
      Transform3D rotation = new Transform3D();
      getRotationTransform(rotation);
      Matrix3d m = new Matrix3d();
      rotation.get(m);
      return Math.atan2(-m.m20, m.m00);
    }

    public void performBehavior() {
      if (distance() < 0.3) {
        setTranslationalVelocity(0);
        setRotationalVelocity(0);
        return;
      }
      Point3d here = new Point3d();
      getCoords(here);
      double h = heading();
      Vector2d force = new Vector2d(goal.x - here.x, -(goal.z - here.z));
      force.normalize();
      for (int i = 0; i < sonars.getNumSensors(); i++) {
        if (sonars.hasHit(i)) {
          double push = 0.4 * (1 / Math.max(0.1, sonars.getMeasurement(i)) - 1 / 1.5);
          double a = h + sonars.getSensorAngle(i);
          force.x -= push * Math.cos(a);
          force.y -= push * Math.sin(a);
        }
      }
      double turn = Math.IEEEremainder(Math.atan2(force.y, force.x) - h, 2 * Math.PI);
      setRotationalVelocity(2 * turn);
      setTranslationalVelocity(0.5 * Math.max(0, Math.cos(turn)));
    }
  }

  public static void main(String[] args) {
    Simbad frame = new Simbad(new PotentialField(), false);
    frame.update(frame.getGraphics());
  }
}
