package simbad.sim;

import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import simbad.kernel.drawing.Facets;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Shape;
import simbad.kernel.scene.Solid;

/**
 * A line on the floor, 8 cm wide, for line sensors. It is in nobody's way. It is 5 mm high and half
 * sunk: its top is 2.5 mm above the floor.
 */
public class Line extends BlockWorldObject {
  private static final float WIDTH_M = 0.08f;
  private static final float HEIGHT_M = 0.005f;

  private final float length;

  /**
   * Creates a black line.
   *
   * @param position middle of its starting edge, metres; copied
   * @param length metres along +z, until the line is turned; a negative one goes the other way
   * @param environment gives the colour
   */
  public Line(Vector3d position, float length, EnvironmentDescription environment) {
    this(position, length, environment, environment.black);
  }

  /**
   * Creates a line.
   *
   * @param position middle of its starting edge, metres; copied
   * @param length metres along +z, until the line is turned
   * @param environment where the line will lie
   * @param color its colour; copied
   */
  public Line(Vector3d position, float length, EnvironmentDescription environment, Color3f color) {
    this.length = length;
    placement().moveTo(position.x, position.y, position.z);
    setCanBeTraversed(true);
    create3D(environment, color);
  }

  /** Gives the line its colour; the window builds what is drawn. */
  protected void create3D(EnvironmentDescription environment, Color3f color) {
    setColor(color);
  }

  /** Returns the strip in its middle's frame, which is half a length ahead of the start. */
  @Override
  protected List<Shape> bodyShapes() {
    return List.of(BoxShape.ofSides(WIDTH_M, HEIGHT_M, Math.abs(length)));
  }

  @Override
  void addShapesTo(Solid body, Placement bodyFromThis) {
    Placement thisFromMiddle = new Placement();
    thisFromMiddle.moveTo(0, 0, length / 2);
    Placement bodyFromMiddle = new Placement();
    bodyFromMiddle.compose(bodyFromThis, thisFromMiddle);
    super.addShapesTo(body, bodyFromMiddle);
  }

  @Override
  protected List<Facets> drawing() {
    return super.drawing().stream().map(strip -> strip.movedBy(0, 0, length / 2)).toList();
  }

  @Override
  boolean stopsThoughTraversable() {
    return false;
  }

  /** Turns the line counter-clockwise by quarter turns about the middle of its starting edge. */
  @Override
  public void rotate90(int quarters) {
    super.rotate90(quarters);
  }
}
