package oldprograms;

import java.text.DecimalFormat;
import javax.media.j3d.Transform3D;
import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Overrides what may be overridden: a kinematic, a robot's body and reset, a key-driven fallback. */
public class OwnParts extends EnvironmentDescription {
  public Cart cart;

  public OwnParts() {
    cart = new Cart(new Vector3d(0, 0, 0), "cart");
    add(cart);
    add(new BallAgent(new Vector3d(0, 0, 3), "ball", new Color3f(1, 1, 0), 0.2f, 0.1f));
  }

  public static class Sideways extends KinematicModel {
    double speed;

    protected void update(double dt, Transform3D rotation, Vector3d translation, Vector3d turn) {
      translation.set(0, 0, -speed * dt);
      rotation.transform(translation);
      turn.set(0, 0, 0);
    }

    protected void reset() {
      speed = 0;
    }

    protected String toString(DecimalFormat format) {
      return "sideways " + format.format(speed);
    }
  }

  public static class Cart extends Agent {
    Sideways sideways = new Sideways();
    KeyInputSensor keys;
    public int resets;

    public Cart(Vector3d position, String name) {
      super(position, name);
      radius = 0.2f;
      height = 0.4f;
      mass = 10;
      setKinematicModel(sideways);
      keys = RobotFactory.addKeyInputSensor(this);
      setColor(new Color3f(0, 0, 1));
    }

    protected void create3D() {
      super.create3D();
    }

    protected void reset() {
      super.reset();
      resets++;
    }

    protected void performBehavior() {
      sideways.speed = keys.getLastKey() == 0 ? 0.5 : 0;
      if (getLifeTime() > 4.99) moveToStartPosition();
    }
  }

  public static void main(String[] args) {
    System.setProperty("j3d.implicitAntialiasing", "true");
    Simbad frame = new Simbad(new OwnParts(), false);
  }
}
