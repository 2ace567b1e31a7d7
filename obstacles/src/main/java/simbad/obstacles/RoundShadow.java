package simbad.obstacles;

/**
 * The detection shadow of {@link RoundObstacle} as it is drawn, in the obstacle's own frame. Needs
 * a display.
 */
public final class RoundShadow extends ShadowShape {
  /** Creates the shape. */
  public RoundShadow() {
    super(Catalogue.find("round").orElseThrow());
  }
}
