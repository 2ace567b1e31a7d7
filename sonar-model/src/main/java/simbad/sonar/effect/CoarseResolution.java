package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Readings come in steps.
 *
 * @param stepM metres; 0 is neutral
 * @param reported what of a step is reported
 */
public record CoarseResolution(double stepM, Reported reported) implements OutputChange {
  /** As a share of a step: what lies so near a report is that report, rounded. */
  private static final double ROUNDING = 1e-9;

  /** Which steps there are, and what each is reported as. */
  public enum Reported {
    /** Steps start at multiples of their length; their start is reported. */
    START(0, 0),
    /** Steps start at multiples of their length; their centre is reported. */
    CENTRE(0, 0.5),
    /** The nearest multiple of the length is reported. */
    NEAREST(-0.5, 0.5);

    private final double start;
    private final double report;

    Reported(double start, double report) {
      this.start = start;
      this.report = report;
    }
  }

  /** Checks the figure; NaN is refused. */
  public CoarseResolution {
    Checks.notNegative("stepM", stepM);
  }

  @Override
  public int order() {
    return 1;
  }

  @Override
  public double reported(double rangeM) {
    return stepM > 0
        ? (Math.floor(rangeM / stepM - reported.start + ROUNDING)
                + reported.start
                + reported.report)
            * stepM
        : rangeM;
  }

  @Override
  public double leastRange(double reportedM) {
    return stepM > 0
        ? (Math.ceil(reportedM / stepM - reported.start - reported.report - ROUNDING)
                + reported.start)
            * stepM
        : reportedM;
  }
}
