package oldprograms;

import java.util.ArrayList;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.gui.Simbad;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** Compares the front quadrants; keeps its obstacles in a raw list. */
public class QuadrantAvoider extends EnvironmentDescription {
  public ArrayList obstacles = new ArrayList();
  public Walker walker = new Walker(new Vector3d(-3, 0, 0.1), "walker");

  public QuadrantAvoider() {
    boxColor = new Color3f(0.6f, 0.5f, 0.3f);
    showAxis(true);
    for (int i = 0; i < 4; i++) {
      obstacles.add(new Box(new Vector3d(i * 1.7 - 1, 0, i % 2 - 0.5), new Vector3f(0.5f, 1, 0.5f), this));
    }
    for (int i = 0; i < obstacles.size(); i++) {
      add(obstacles.get(i));
    }
    add(walker);
  }

  public static class Walker extends Agent {
    RangeSensorBelt sonars, bumpers;

    public Walker(Vector3d p, String n) {
      super(p, n);
      sonars = RobotFactory.addSonarBeltSensor(this, 24);
      sonars.setUpdateOnEachFrame(true);
      bumpers = RobotFactory.addBumperBeltSensor(this);
    }

    protected void initBehavior() {}

    protected void performBehavior() {
      if (bumpers.oneHasHit()) {
        setTranslationalVelocity(-0.1);
        setRotationalVelocity(0.5);
      } else if (sonars.oneHasHit()) {
        double left = sonars.getFrontLeftQuadrantMeasurement();
        double right = sonars.getFrontRightQuadrantMeasurement();
        double front = sonars.getFrontQuadrantMeasurement();
        if (front < 0.7 || left < 0.7 || right < 0.7) {
          setRotationalVelocity(left < right ? -1 : 1);
          setTranslationalVelocity(0.2);
        } else {
          setRotationalVelocity(0);
          setTranslationalVelocity(0.6);
        }
      } else {
        setTranslationalVelocity(0.8);
        setRotationalVelocity(0);
      }
    }
  }

  public static void main(String[] args) {
    new Simbad(new QuadrantAvoider(), false);
  }
}
