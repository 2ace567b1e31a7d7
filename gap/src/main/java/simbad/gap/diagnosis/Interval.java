package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * An interval of numbers, both ends included.
 *
 * @param low not above high; may be negative infinity where the data do not bound it
 * @param high may be positive infinity
 */
public record Interval(double low, double high) {
  /** Refuses what is no number. */
  public Interval {
    Checks.number("low", low);
    Checks.number("high", high);
  }

  /** Returns the least interval that holds this one and another. */
  public Interval hull(Interval other) {
    return new Interval(Math.min(low, other.low), Math.max(high, other.high));
  }
}
