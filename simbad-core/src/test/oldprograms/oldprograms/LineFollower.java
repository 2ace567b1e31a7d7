package oldprograms;

import javax.vecmath.Vector3d;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Keeps the hits of 11 rays in their middle. */
public class LineFollower extends EnvironmentDescription {
  public Follower follower;

  public LineFollower() {
    Line line = new Line(new Vector3d(-2, 0, 0), 8, this);
    line.rotate90(1);
    add(line);
    follower = new Follower(new Vector3d(-2, 0, 0.05), "line follower");
    add(follower);
  }

  public static class Follower extends Agent {
    LineSensor line;
    public int seen;

    public Follower(Vector3d position, String name) {
      super(position, name);
      line = RobotFactory.addLineSensor(this, 11);
    }

    public void performBehavior() {
      int left = 0, right = 0;
      for (int i = 0; i < line.getNumSensors() / 2; i++) {
        left += line.hasHit(i) ? 1 : 0;
        right += line.hasHit(line.getNumSensors() - i - 1) ? 1 : 0;
        seen += left + right;
      }
      setRotationalVelocity((left - right) * 0.5);
      setTranslationalVelocity(0.4);
    }
  }

  public static void main(String[] args) {
    System.setProperty("j3d.implicitAntialiasing", "true");
    Simbad frame = new Simbad(new LineFollower(), false);
  }
}
