package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * A value with how well it is known, as a normal likelihood.
 *
 * @param value where it is greatest
 * @param deviation standard deviation, above 0; infinite where nothing is known
 */
public record Estimate(double value, double deviation) {
  private static final double NORMAL_95 = 1.96;

  /** Farther apart two estimates of one value are once in some ten thousand times. */
  private static final double APART = 4;

  /** Checks the deviation; NaN is refused. */
  public Estimate {
    Checks.number("value", value);
    Checks.number("deviation", deviation);
    if (!(deviation > 0)) {
      throw new IllegalArgumentException("deviation = " + deviation + " is not above 0");
    }
  }

  /** Returns the ends between which it lies 19 times of 20. */
  public Interval ci95() {
    return new Interval(value - NORMAL_95 * deviation, value + NORMAL_95 * deviation);
  }

  /** Returns what two independent estimates of one value say together: their product. */
  public Estimate and(Estimate other) {
    if (deviation == Double.POSITIVE_INFINITY) {
      return other;
    }
    double own = 1 / (deviation * deviation);
    double others = 1 / (other.deviation * other.deviation);
    return new Estimate(
        (own * value + others * other.value) / (own + others), 1 / Math.sqrt(own + others));
  }

  /**
   * Tells whether two estimates are of one value.
   *
   * @param other estimate
   * @param practical difference that would matter to nobody, however sure it is
   */
  public boolean agrees(Estimate other, double practical) {
    double apart = Math.abs(value - other.value);
    return apart <= practical || apart <= APART * Math.hypot(deviation, other.deviation);
  }
}
