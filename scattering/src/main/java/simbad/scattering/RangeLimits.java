package simbad.scattering;

/**
 * Between blanking and time-out.
 *
 * @param minRangeM echoes from nearer are blanked out; positive
 * @param maxRangeM echoes from further come after the time-out; above minRangeM, up to 100
 */
public record RangeLimits(double minRangeM, double maxRangeM) {
  private static final double GREATEST_M = 100;

  /** Checks both. */
  public RangeLimits {
    if (!(minRangeM > 0 && minRangeM < maxRangeM && maxRangeM <= GREATEST_M)) {
      throw new IllegalArgumentException(
          "minRangeM = "
              + minRangeM
              + ", maxRangeM = "
              + maxRangeM
              + " are not 0 < minRangeM < maxRangeM <= "
              + GREATEST_M);
    }
  }
}
