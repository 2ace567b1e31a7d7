package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Every range is read too long or too short by the same amount, and the sensor's least range is one
 * of what it reads: echoes that would read less are lost.
 *
 * @param offset of the ranges
 * @param softM how much readings scatter there, metres; positive
 */
public record GatedOffset(RangeOffset offset, double softM) implements RangeChange, EchoChange {
  /** Checks the figures; NaN is refused. */
  public GatedOffset {
    Checks.positive("softM", softM);
  }

  @Override
  public int order() {
    return offset.order();
  }

  @Override
  public double meanM(double rangeM) {
    return offset.meanM(rangeM);
  }

  @Override
  public double rangeM(double meanM) {
    return offset.rangeM(meanM);
  }

  @Override
  public double share(Geometry geometry, int line) {
    double beyond = offset.meanM(geometry.nearestM(line)) - geometry.sensor().minRangeM();
    return offset.offsetM() < 0 ? 1 / (1 + Math.exp(-beyond / softM)) : 1;
  }
}
