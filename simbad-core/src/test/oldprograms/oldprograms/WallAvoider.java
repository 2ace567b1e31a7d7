package oldprograms;

import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** The stock avoider: sonars, bumpers, a random-like turn at a collision, a camera left out. */
public class WallAvoider extends EnvironmentDescription {
  public Robot robot;

  public WallAvoider() {
    light1IsOn = true;
    light2IsOn = false;
    setWorldSize(25);
    wallColor = red;
    Wall w1 = new Wall(new Vector3d(4, 0, 0), 8, 1, this);
    w1.rotate90(1);
    add(w1);
    Wall w2 = new Wall(new Vector3d(-4, 0, 0), 8, 1, this);
    w2.rotate90(1);
    add(w2);
    add(new Wall(new Vector3d(0, 0, 4), 8, 1, this));
    add(new Wall(new Vector3d(0, 0, -4), 8, 2, this));
    add(new Arch(new Vector3d(3, 0, -3), this));
    robot = new Robot(new Vector3d(0, 0, 0), "robot 1");
    add(robot);
  }

  /** Its name is in simbad.sim, too. */
  public class Robot extends Agent {
    RangeSensorBelt sonars;
    RangeSensorBelt bumpers;
    public int collisions = 0;

    public Robot(Vector3d position, String name) {
      super(position, name);
      bumpers = RobotFactory.addBumperBeltSensor(this, 12);
      sonars = RobotFactory.addSonarBeltSensor(this, 4);
    }

    public void initBehavior() {
      collisions = 0;
    }

    public void performBehavior() {
      if (collisionDetected()) {
        collisions++;
        setTranslationalVelocity(0.0);
        setRotationalVelocity(1);
      } else if (getCounter() % 20 == 0) {
        setTranslationalVelocity(0.5);
        setRotationalVelocity(sonars.oneHasHit() ? Math.PI / 4 : 0);
      }
    }
  }

  public static void main(String[] args) {
    System.setProperty("j3d.implicitAntialiasing", "true");
    Simbad frame = new Simbad(new WallAvoider(), false);
  }
}
