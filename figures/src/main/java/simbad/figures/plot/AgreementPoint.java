package simbad.figures.plot;

/**
 * One claim, or a group of claims, against what was so.
 *
 * @param claimed finite
 * @param found finite
 * @param low lower end of the interval of what was found; {@code found} where there is none
 * @param high its upper end, not below {@code low}
 * @param label what stands beside the point, such as a count; may be empty
 */
public record AgreementPoint(double claimed, double found, double low, double high, String label) {
  /** Refuses what cannot be drawn. */
  public AgreementPoint {
    Checks.finite("claimed", claimed);
    Checks.finite("found", found);
    Checks.finite("low", low);
    Checks.finite("high", high);
    if (high < low) {
      throw new IllegalArgumentException("high = " + high + " is below low = " + low);
    }
  }

  /** A point without interval and label. */
  public static AgreementPoint of(double claimed, double found) {
    return new AgreementPoint(claimed, found, found, found, "");
  }
}
