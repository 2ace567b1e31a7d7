package simbad.sonar.effect;

/**
 * Readings come in steps.
 *
 * @param stepM metres; 0 is neutral
 * @param centred whether a step is reported by its centre, not by its start
 */
public record CoarseResolution(double stepM, boolean centred) implements OutputChange {
  /** As a share of a step: what lies so near a report is that report, rounded. */
  private static final double ROUNDING = 1e-9;

  @Override
  public int order() {
    return 1;
  }

  @Override
  public double reported(double rangeM) {
    return stepM > 0 ? Math.floor(rangeM / stepM + ROUNDING) * stepM + shiftM() : rangeM;
  }

  @Override
  public double leastRange(double reportedM) {
    return stepM > 0 ? Math.ceil((reportedM - shiftM()) / stepM - ROUNDING) * stepM : reportedM;
  }

  private double shiftM() {
    return centred ? stepM / 2 : 0;
  }
}
