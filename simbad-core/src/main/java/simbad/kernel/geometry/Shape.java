package simbad.kernel.geometry;

/**
 * A solid in its own frame, of which bodies consist. Shapes are immutable values.
 *
 * <p>The set is closed so that the window can draw, and an index can bound, every one of them.
 */
public sealed interface Shape permits BoxShape, PrismShape, CylinderShape, BallShape {
  /**
   * Shortens a ray to this shape's surface if that is within its reach. A ray that starts inside
   * meets the far side.
   *
   * @param ray in this shape's frame
   * @return true if the ray was met (and then is no longer than the way to the surface)
   */
  boolean strike(Ray ray);

  /**
   * Grows an extent by the world-frame box round this shape. The box is tight, except that a tilted
   * cylinder or prism may get a larger one.
   *
   * @param worldFromShape where the shape is
   * @param extent is grown
   */
  void addTo(Extent extent, Placement worldFromShape);
}
