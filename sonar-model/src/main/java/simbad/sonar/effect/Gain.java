package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Every echo is weaker or stronger: all thresholds shrink or grow in proportion.
 *
 * @param factor of the thresholds; 1 is neutral
 */
public record Gain(double factor) implements ThresholdChange {
  /** Checks the figure; NaN is refused. */
  public Gain {
    Checks.notNegative("factor", factor);
  }

  @Override
  public double factor(Geometry geometry, int line) {
    return factor;
  }
}
