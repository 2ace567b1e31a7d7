package oldprograms;

import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** A Khepera that turns away from what its infrared sensors see. */
public class KheperaMaze extends EnvironmentDescription {
  public KheperaRobot robot;

  public KheperaMaze() {
    setWorldSize(1);
    addBox(0.2, 0, 0.05f, 0.4f);
    addBox(-0.2, 0, 0.05f, 0.4f);
    addBox(0, 0.2, 0.4f, 0.05f);
    addBox(0, -0.2, 0.4f, 0.05f);
    robot =
        new KheperaRobot(new Vector3d(0, 0, 0), "khepera") {
          public void performBehavior() {
            RangeSensorBelt ir = getIRSensors();
            boolean blocked = ir.hasHit(1) || ir.hasHit(2) || ir.hasHit(3) || ir.hasHit(4);
            if (blocked) setWheelsVelocity(0.02, -0.02);
            else setWheelsVelocity(0.05, 0.05);
          }
        };
    robot.getIRSensors().setUpdateOnEachFrame(true);
    add(robot);
  }

  void addBox(double x, double z, float sx, float sz) {
    add(new Box(new Vector3d(x, 0, z), new Vector3f(sx, 0.1f, sz), this, darkgray));
  }

  public static void main(String[] args) {
    Simbad frame = new Simbad(new KheperaMaze(), false);
    frame.update(frame.getGraphics());
  }
}
