package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The number that the sensor would give is multiplied before it is stored: a wrong constant or a
 * wrong unit in somebody's program. Noise and steps are scaled with the range.
 *
 * @param scale stored over given; above 0, 1 is neutral
 * @param resolutionM steps in which the sensor gives it, metres; 0 for none
 */
public record ReadingScale(double scale, double resolutionM) implements OutputChange {
  /** As a share of a step: what lies so near to a step's start is that start, rounded. */
  private static final double ROUNDING = 1e-9;

  /** Checks the figures; NaN is refused. */
  public ReadingScale {
    Checks.positive("scale", scale);
    Checks.notNegative("resolutionM", resolutionM);
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public double reported(double rangeM) {
    if (scale == 1) {
      return rangeM;
    }
    double given =
        resolutionM > 0 ? Math.floor(rangeM / resolutionM + ROUNDING) * resolutionM : rangeM;
    return scale * given;
  }

  @Override
  public double leastRange(double reportedM) {
    if (scale == 1) {
      return reportedM;
    }
    double given = reportedM / scale;
    return resolutionM > 0 ? Math.ceil(given / resolutionM - ROUNDING) * resolutionM : given;
  }
}
