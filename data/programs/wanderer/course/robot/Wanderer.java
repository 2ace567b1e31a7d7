package course.robot;

import helper.Dice;
import java.util.Random;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.gui.Simbad;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** Fährt umher, wie in einer Übung: in ISO-8859-1, mit einem Fenster, mit Zufall. */
public class Wanderer extends EnvironmentDescription {
  public Wanderer() {
    add(new Box(new Vector3d(2, 0, 0), new Vector3f(1, 1, 1), this));
    add(new Läufer(new Vector3d(0, 0, 0), "Läufer"));
    add(new Läufer(new Vector3d(-3, 0, 1), "Zweiter"));
  }

  static class Läufer extends Agent {
    private final RangeSensorBelt sonars = RobotFactory.addSonarBeltSensor(this, 8);
    private final Random random = new Random();

    Läufer(Vector3d position, String name) {
      super(position, name);
    }

    public void performBehavior() {
      setTranslationalVelocity(0.5);
      if (collisionDetected() || sonars.getMeasurement(0) < 0.5) {
        setRotationalVelocity(1 + random.nextDouble());
      } else {
        setRotationalVelocity(Math.random() - 0.5 + Dice.bias());
      }
    }
  }

  public static void main(String[] args) {
    Simbad frame = new Simbad(new Wanderer(), false);
    frame.setTitle("Übung 3");
  }
}
