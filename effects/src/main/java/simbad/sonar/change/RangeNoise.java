package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.RangeChange;

/**
 * Ranges scatter more than believed; the scatter adds to the sensor's own in squares.
 *
 * @param addedM standard deviation at any range, metres; 0 is neutral
 * @param addedPerM standard deviation for each metre of range; 0 is neutral
 */
public record RangeNoise(double addedM, double addedPerM) implements RangeChange {
  /** Checks the figures; NaN is refused. */
  public RangeNoise {
    Checks.notNegative("addedM", addedM);
    Checks.notNegative("addedPerM", addedPerM);
  }

  @Override
  public int order() {
    return 2;
  }

  @Override
  public double deviationM(double rangeM, double deviationM) {
    double growing = addedPerM * rangeM;
    double added = addedM * addedM + growing * growing;
    return added == 0 ? deviationM : Math.sqrt(deviationM * deviationM + added);
  }
}
