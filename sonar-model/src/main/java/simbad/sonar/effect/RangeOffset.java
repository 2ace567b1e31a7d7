package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Every range is too long by the same amount.
 *
 * @param offsetM metres; 0 is neutral
 */
public record RangeOffset(double offsetM) implements RangeChange {
  /** Checks the figure; NaN is refused. */
  public RangeOffset {
    Checks.finite("offsetM", offsetM);
  }

  @Override
  public int order() {
    return 1;
  }

  @Override
  public double meanM(double rangeM) {
    return rangeM + offsetM;
  }

  @Override
  public double rangeM(double meanM) {
    return meanM - offsetM;
  }
}
