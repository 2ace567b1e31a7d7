package simbad.obstacles;

/**
 * The detection shadow of {@link AngleObstacle} as it is drawn, in the obstacle's own frame. Needs
 * a display.
 */
public final class AngleShadow extends ShadowShape {
  /** Creates the shape. */
  public AngleShadow() {
    super(Catalogue.find("angle").orElseThrow());
  }
}
