package simbad.bench.capture;

/**
 * A distance that is to be tried.
 *
 * @param distanceM from the sensor to the obstacle's axis, metres, above 0
 * @param approach why
 */
public record TriedDistance(double distanceM, Approach approach) {
  /** Checks the distance. */
  public TriedDistance {
    if (!(distanceM > 0 && distanceM < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("distanceM = " + distanceM + " is not in (0, infinity)");
    }
  }
}
