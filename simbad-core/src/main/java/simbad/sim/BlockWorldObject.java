package simbad.sim;

import java.util.List;
import javax.vecmath.Color3f;
import simbad.kernel.drawing.Facets;

/** A static object of the block world, turned by quarter turns. */
public class BlockWorldObject extends StaticObject {
  static final float BRIGHTEST = 0.8f;

  /** Share of its colour that a wall reflects of the light from everywhere. */
  private static final float AMBIENT_SHARE = 0.3f;

  /** Creates an object at the origin. */
  public BlockWorldObject() {}

  /** Sets the colour, each component at most 0.8; the argument is copied. */
  @Override
  public void setColor(Color3f color) {
    Color3f dimmed = new Color3f(color);
    dimmed.clampMax(BRIGHTEST);
    super.setColor(dimmed);
  }

  @Override
  protected List<Facets> drawing() {
    return super.drawing().stream()
        .map(facets -> new Facets(facets.mesh(), facets.finish().reflecting(AMBIENT_SHARE)))
        .toList();
  }

  /** Turns the object counter-clockwise by quarter turns about its own vertical axis. */
  public void rotate90(int quarters) {
    placement().turnQuarters(quarters);
    placementChanged();
  }
}
