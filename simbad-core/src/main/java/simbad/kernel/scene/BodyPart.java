package simbad.kernel.scene;

import simbad.kernel.geometry.Extent;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Ray;
import simbad.kernel.geometry.Shape;

/** One shape of a solid, with its place in the world. */
public final class BodyPart {
  /** Room for rounding: what a ray grazes exactly is still looked at exactly. */
  private static final double MARGIN_M = 1e-9;

  private final Solid solid;
  private final Shape shape;
  private final Placement solidFromPart;
  private final Placement worldFromPart;
  private final Extent extent = new Extent();
  private final Extent cover = new Extent();

  BodyPart(Solid solid, Shape shape, Placement solidFromPart) {
    this.solid = solid;
    this.shape = shape;
    this.solidFromPart = solidFromPart;
    this.worldFromPart = new Placement();
  }

  /** Returns the shape, in the part's own frame. */
  public Shape shape() {
    return shape;
  }

  /** Returns where the part is; to be read only. It follows the solid once that {@code moved()}. */
  public Placement worldFromPart() {
    solid.refresh();
    return worldFromPart;
  }

  /** Returns the world-frame box round the part; to be read only. */
  public Extent extent() {
    solid.refresh();
    return extent;
  }

  Solid solid() {
    return solid;
  }

  void refresh(Placement worldFromSolid) {
    worldFromPart.compose(worldFromSolid, solidFromPart);
    extent.clear();
    shape.addTo(extent, worldFromPart);
    cover.clear();
    cover.include(extent);
    cover.grow(MARGIN_M);
  }

  /** Casts a world ray; {@code local} is scratch space. */
  boolean strike(Ray world, Ray local) {
    local.setToLocal(world, worldFromPart);
    return shape.strike(local) && world.shortenTo(local.lengthM());
  }

  /** Returns the extent, a little larger, as it was when the solid was last refreshed. */
  Extent cover() {
    return cover;
  }
}
