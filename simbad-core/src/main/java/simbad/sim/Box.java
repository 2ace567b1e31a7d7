package simbad.sim;

import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Shape;

/** A box. */
public class Box extends BlockWorldObject {
  private final Vector3f sides;

  /**
   * Creates a box of the environment's box colour.
   *
   * @param position middle of the bottom face, metres; copied
   * @param sizes sides along x, y, z, metres; copied. A negative height hangs below the position,
   *     the sign of the others is of no account
   * @param environment gives the colour
   */
  public Box(Vector3d position, Vector3f sizes, EnvironmentDescription environment) {
    this(position, sizes, environment, environment.boxColor);
  }

  /**
   * Creates a box.
   *
   * @param position middle of the bottom face, metres; copied
   * @param sizes sides along x, y, z, metres; copied
   * @param environment where the box will stand
   * @param color its colour; copied
   */
  public Box(Vector3d position, Vector3f sizes, EnvironmentDescription environment, Color3f color) {
    sides = new Vector3f(sizes);
    placement().moveTo(position.x, position.y + sizes.y / 2, position.z);
    create3D(environment, color);
    boolean changes = environment.compatibility.contains(Compatibility.ARGUMENTS_CHANGE);
    if (environment.isSecondUse(position) && sizes.y != 0) {
      environment.meets(Compatibility.ARGUMENTS_CHANGE);
    }
    if (changes) {
      position.y += sizes.y / 2;
      color.clampMax(BRIGHTEST);
    }
  }

  /** Gives the box its colour; the window builds what is drawn. */
  protected void create3D(EnvironmentDescription environment, Color3f color) {
    setColor(color);
  }

  @Override
  protected List<Shape> bodyShapes() {
    return List.of(BoxShape.ofSides(Math.abs(sides.x), Math.abs(sides.y), Math.abs(sides.z)));
  }
}
