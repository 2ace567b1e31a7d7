package oldprograms;

import java.util.Iterator;
import javax.vecmath.*;
import simbad.gui.Simbatch;
import simbad.sim.*;

/** Robots of one class that signal with lamps when they meet; walks the raw sensor list. */
public class Blinkers extends EnvironmentDescription {
  public Blinker[] blinkers = new Blinker[2];

  public Blinkers() {
    for (int i = 0; i < blinkers.length; i++) {
      add(blinkers[i] = new Blinker(new Vector3d(4 * i - 2, 0, 0), "blinker " + i, i));
    }
  }

  public static class Blinker extends Agent {
    LampActuator lamp;
    int side;
    public int devices;

    public Blinker(Vector3d position, String name, int side) {
      super(position, name);
      this.side = side;
      lamp = RobotFactory.addLamp(this);
      RobotFactory.addSonarBeltSensor(this);
      RobotFactory.addKeyInputSensor(this);
    }

    public void initBehavior() {
      rotateY(side * Math.PI);
      devices = 0;
      for (Iterator it = getSensorList().iterator(); it.hasNext(); ) {
        SensorDevice device = (SensorDevice) it.next();
        if (device.getName() != null) devices++;
      }
    }

    public void performBehavior() {
      boolean met = anOtherAgentIsVeryNear();
      lamp.setOn(met || lamp.getOn());
      lamp.setBlink(met);
      setTranslationalVelocity(0.5);
    }
  }

  public static void main(String[] args) {
    Simbatch sim = new Simbatch(new Blinkers(), false);
    sim.reset();
    for (int i = 0; i < 100; i++) sim.step();
    sim.dispose();
  }
}
