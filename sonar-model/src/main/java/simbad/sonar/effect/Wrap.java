package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Readings start again from 0 beyond some value, as where a byte or a timer overflows.
 *
 * @param modulusM metres, above 0; infinity is neutral
 */
public record Wrap(double modulusM) implements RangeChange {
  /** Checks the figure; NaN is refused. */
  public Wrap {
    Checks.positiveOrInfinite("modulusM", modulusM);
  }

  @Override
  public int order() {
    return 3;
  }

  @Override
  public double meanM(double rangeM) {
    return rangeM < modulusM ? rangeM : rangeM % modulusM;
  }

  /** Nobody knows how often it began again: the range is taken for one that did not. */
  @Override
  public double rangeM(double meanM) {
    return meanM;
  }
}
