package simbad.sim;

import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.Shape;

/** A cherry: seen by sensors, in nobody's way. */
public class CherryAgent extends SimpleAgent {
  /**
   * Creates a cherry.
   *
   * @param pos where it touches the floor at the start, metres; copied
   * @param name its name
   * @param radius metres
   */
  public CherryAgent(Vector3d pos, String name, float radius) {
    super(pos, name);
    this.radius = radius;
    height = 2 * radius;
    mass = 0;
    setColor(new Color3f(0.8f, 0, 0));
    setCanBeTraversed(true);
  }

  @Override
  protected List<Shape> bodyShapes() {
    return List.of(new BallShape(radius));
  }

  @Override
  protected void create3D() {
    super.create3D();
  }
}
