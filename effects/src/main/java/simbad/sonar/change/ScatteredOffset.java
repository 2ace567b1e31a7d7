package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.RangeChange;

/**
 * Every range is too long by about the same amount, as when what triggers a ping comes late by more
 * or less.
 *
 * @param offset on average
 * @param share standard deviation of the amount over its size, at least 0; 0 for none
 */
public record ScatteredOffset(RangeOffset offset, double share) implements RangeChange {
  /** Checks the figure; NaN is refused. */
  public ScatteredOffset {
    Checks.notNegative("share", share);
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
  public double deviationM(double rangeM, double deviationM) {
    double added = share * offset.offsetM();
    return added == 0 ? deviationM : Deviations.together(deviationM, added);
  }
}
