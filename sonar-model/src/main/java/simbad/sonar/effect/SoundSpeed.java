package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Sound is faster or slower than assumed: time is right, range is scaled.
 *
 * @param scale range read over true range; 1 is neutral
 */
public record SoundSpeed(double scale) implements RangeChange {
  /** Checks the figure; NaN is refused. */
  public SoundSpeed {
    Checks.positive("scale", scale);
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public double meanM(double rangeM) {
    return rangeM * scale;
  }

  @Override
  public double rangeM(double meanM) {
    return meanM / scale;
  }
}
