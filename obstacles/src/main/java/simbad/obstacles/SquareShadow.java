package simbad.obstacles;

/**
 * The detection shadow of {@link SquareObstacle} as it is drawn, in the obstacle's own frame. Needs
 * a display.
 */
public final class SquareShadow extends ShadowShape {
  /** Creates the shape. */
  public SquareShadow() {
    super(Catalogue.find("square").orElseThrow());
  }
}
