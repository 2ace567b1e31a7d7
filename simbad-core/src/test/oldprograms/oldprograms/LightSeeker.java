package oldprograms;

import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Drives to the lamp by two light sensors, turning to the brighter side; a lamp shows success. */
public class LightSeeker extends EnvironmentDescription {
  public Seeker seeker;

  public LightSeeker() {
    this.light1IsOn = true;
    this.light1SetPosition(6, 1.5, -4);
    this.light2IsOn = false;
    ambientLightColor = darkgray;
    add(new Box(new Vector3d(-3, 0, -3), new Vector3f(1, 1, 1), this));
    seeker = new Seeker(new Vector3d(-4, 0, 3), "seeker");
    add(seeker);
  }

  public static class Seeker extends Agent {
    private LightSensor left;
    private LightSensor right;
    private LampActuator lamp;
    public double nearest = Double.MAX_VALUE;

    public Seeker(Vector3d position, String name) {
      super(position, name);
      left = RobotFactory.addLightSensorLeft(this);
      right = RobotFactory.addLightSensorRight(this);
      lamp = RobotFactory.addLamp(this);
    }

    protected void initBehavior() {
      lamp.setOn(false);
    }

    protected void performBehavior() {
      float l = left.getAverageLuminance();
      float r = right.getAverageLuminance();
      setTranslationalVelocity(0.5 / getFramesPerSecond() * 20);
      setRotationalVelocity((l - r) * Math.PI / 4);
      Point3d at = new Point3d();
      getCoords(at);
      nearest = Math.min(nearest, Math.hypot(at.x - 6, at.z + 4));
      if (nearest < 1) {
        lamp.setOn(true);
      }
    }
  }

  public static void main(String[] args) {
    new Simbad(new LightSeeker(), false);
  }
}
