package oldprograms;

import javax.vecmath.*;
import simbad.demo.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Picks up what is near; extends the class of the demos. */
public class CherryPicker extends Demo {
  public Picker picker = new Picker(new Vector3d(-3, 0, 0), "picker");

  public CherryPicker() {
    for (int i = 0; i < 5; i++) {
      add(new CherryAgent(new Vector3d(i - 2, 0, 0), "cherry" + i, 0.15f));
    }
    add(picker);
  }

  public class Picker extends Agent {
    public int picked;

    public Picker(Vector3d position, String name) {
      super(position, name);
    }

    public void performBehavior() {
      setTranslationalVelocity(0.5);
      if (anOtherAgentIsVeryNear()) {
        SimpleAgent agent = getVeryNearAgent();
        if (agent instanceof CherryAgent) {
          agent.detach();
          picked++;
        }
      }
    }
  }

  public static void main(String[] args) {
    System.setProperty("j3d.implicitAntialiasing", "true");
    Simbad frame = new Simbad(new CherryPicker(), false);
  }
}
