package oldprograms;

import javax.vecmath.Vector3d;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Finds the lamp by lux, written for the later jar, and stops where it gets darker again. */
public class LuxClimber extends EnvironmentDescription {
  public Climber climber;

  public LuxClimber() {
    light1SetPosition(3, 1, 2);
    light2IsOn = false;
    climber = new Climber(new Vector3d(-3, 0, 0), "climber");
    add(climber);
  }

  public class Climber extends Agent {
    LightSensor left;
    LightSensor right;
    LightSensor center;
    double last;
    public boolean arrived;

    public Climber(Vector3d position, String name) {
      super(position, name);
      left = RobotFactory.addLightSensorLeft(this);
      right = RobotFactory.addLightSensorRight(this);
      center = RobotFactory.addLightSensor(this, new Vector3d(0, 0.2, 0), 0, "center");
    }

    public void performBehavior() {
      double lux = center.getLux();
      double difference = left.getLux() - right.getLux();
      arrived = arrived || (getCounter() > 100 && lux < last);
      setTranslationalVelocity(arrived ? 0 : 0.4);
      setRotationalVelocity(arrived ? 0 : 8 * difference / lux);
      last = lux;
    }
  }

  public static void main(String[] args) {
    Simbad frame = new Simbad(new LuxClimber(), false);
    frame.update(frame.getGraphics());
  }
}
