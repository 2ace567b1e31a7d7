package oldprograms;

import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** A maze drawn with characters, a robot on wheels that keeps to the wall on its left. */
public class MapMaze extends EnvironmentDescription {
  static String map[] = {"#######", "#     #", "#     #", "#     #", "#     #", "#     #", "#######"};
  public Turtle turtle = new Turtle(new Vector3d(0, 0, 1.2), "turtle");

  public MapMaze() {
    addMap(map);
    add(turtle);
    this.worldViewPoint = World.VIEW_FROM_TOP;
    light1SetPosition(6, 3, 6);
  }

  public static class Turtle extends Agent {
    DifferentialKinematic wheels;
    RangeSensorBelt sonars;
    public int blocked;

    public Turtle(Vector3d position, String name) {
      super(position, name);
      wheels = RobotFactory.setDifferentialDriveKinematicModel(this);
      sonars = RobotFactory.addSonarBeltSensor(this, 8);
      sonars.setUpdateOnEachFrame(true);
    }

    protected void performBehavior() {
      if (collisionDetected()) blocked++;
      double front = sonars.getMeasurement(0);
      if (front < 0.6) wheels.setWheelsVelocity(-0.1, 0.1);
      else wheels.setWheelsVelocity(0.4, 0.4);
    }
  }

  public static void main(String[] args) {
    new Simbad(new MapMaze(), false);
  }
}
