package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * A fitted parameter.
 *
 * @param name with its unit
 * @param value fitted
 * @param ci95 95 % confidence interval; infinite ends where the data do not bound it
 */
public record FittedParameter(String name, double value, Interval ci95) {
  /** Refuses what is no number. */
  public FittedParameter {
    Checks.number("value", value);
  }

  /** Returns the same with another interval. */
  public FittedParameter with(Interval other) {
    return new FittedParameter(name, value, other);
  }
}
