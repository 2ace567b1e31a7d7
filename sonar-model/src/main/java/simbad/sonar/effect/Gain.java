package simbad.sonar.effect;

/**
 * Every echo is weaker or stronger: all thresholds shrink or grow in proportion.
 *
 * @param factor of the thresholds; 1 is neutral
 */
public record Gain(double factor) implements ThresholdChange {
  @Override
  public double factor(Geometry geometry, int line) {
    return factor;
  }
}
