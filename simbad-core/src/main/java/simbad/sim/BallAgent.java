package simbad.sim;

import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.Shape;

/** A ball. */
public class BallAgent extends SimpleAgent {
  private static final float DEFAULT_MASS_KG = 0.25f;

  /**
   * Creates a ball.
   *
   * @param pos where it touches the floor at the start, metres; copied
   * @param name its name
   * @param color its colour; copied
   * @param radius metres
   * @param mass kilograms
   */
  public BallAgent(Vector3d pos, String name, Color3f color, float radius, float mass) {
    super(pos, name);
    this.radius = radius;
    this.mass = mass;
    height = 2 * radius;
    staticFrictionCoefficient = 0.1f;
    setColor(color);
  }

  /**
   * Creates an orange ball of 0.25 kg.
   *
   * @param pos where it touches the floor at the start, metres; copied
   * @param name its name
   * @param radius metres
   */
  public BallAgent(Vector3d pos, String name, float radius) {
    this(pos, name, new Color3f(1, 0.2f, 0.05f), radius, DEFAULT_MASS_KG);
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
