package simbad.sonar.shape;

/**
 * How far a table's thresholds are uncertain, bearing by bearing.
 *
 * @param low lower ends, metres
 * @param high upper ends, of the same bearings; nowhere less than the lower ends
 */
public record ThresholdBand(ThresholdTable low, ThresholdTable high) {
  private static final double ROUNDING_M = 1e-9;

  /** Checks sizes and order. */
  public ThresholdBand {
    if (low.size() != high.size()) {
      throw new IllegalArgumentException(
          "low has " + low.size() + " bearings, high " + high.size());
    }
    for (int i = 0; i < low.size(); i++) {
      if (low.valueM(i) > high.valueM(i)) {
        throw new IllegalArgumentException(
            "low = " + low.valueM(i) + " is above high = " + high.valueM(i) + " m");
      }
    }
  }

  /** Returns the number of bearings. */
  public int size() {
    return low.size();
  }

  /**
   * Tells whether a threshold lies in the band.
   *
   * @param bearingRad in [0, 2 pi)
   * @param thresholdM metres; a band's ends, rounded as in a file, are in it
   */
  public boolean holds(double bearingRad, double thresholdM) {
    return low.thresholdM(bearingRad) <= thresholdM + ROUNDING_M
        && thresholdM - ROUNDING_M <= high.thresholdM(bearingRad);
  }
}
