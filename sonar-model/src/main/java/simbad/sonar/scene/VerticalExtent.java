package simbad.sonar.scene;

/**
 * From where to where an obstacle reaches over the floor.
 *
 * @param bottomM metres over the floor; negative infinity for no end
 * @param topM metres over the floor, above the bottom; infinity for no end
 */
public record VerticalExtent(double bottomM, double topM) {
  /** Without an end either way, as everything is in a scene seen from above. */
  public static final VerticalExtent ENDLESS =
      new VerticalExtent(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Checks the order. */
  public VerticalExtent {
    if (!(bottomM < topM)) {
      throw new IllegalArgumentException("topM = " + topM + " is not above bottomM = " + bottomM);
    }
  }
}
