package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Ranges below a least value are reported as that value.
 *
 * @param leastM metres; 0 is neutral
 */
public record NearClamp(double leastM) implements OutputChange {
  /** Checks the figure; NaN is refused. */
  public NearClamp {
    Checks.notNegative("leastM", leastM);
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public double reported(double rangeM) {
    return leastM > 0 ? Math.max(rangeM, leastM) : rangeM;
  }

  @Override
  public double leastRange(double reportedM) {
    return leastM > 0 && reportedM <= leastM ? Double.NEGATIVE_INFINITY : reportedM;
  }
}
