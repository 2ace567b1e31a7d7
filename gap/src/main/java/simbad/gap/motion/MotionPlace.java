package simbad.gap.motion;

import simbad.sonar.check.Checks;

/**
 * A slice of the windows of half a second.
 *
 * @param axis what is sliced
 * @param name of the run, the only thing that is sliced by name; empty for numbers
 * @param low where the slice begins
 * @param high where it ends
 * @param rows windows in it
 * @param share of the whole gap over half a second
 * @param before mean gap in it, in units of the mean gap of all windows
 * @param after the same of the diagnosed model
 * @param component where its gap is greatest: along, across or turn
 * @param qValue how probable it is, corrected for the number of slices, that chance alone makes the
 *     gap before greater than after
 */
public record MotionPlace(
    String axis,
    String name,
    double low,
    double high,
    int rows,
    double share,
    double before,
    double after,
    String component,
    double qValue) {
  /** Refuses what is no number. */
  public MotionPlace {
    Checks.number("low", low);
    Checks.number("high", high);
    Checks.number("share", share);
    Checks.number("before", before);
    Checks.number("after", after);
    Checks.number("qValue", qValue);
  }
}
