package simbad.experiments.fidelity;

import simbad.sonar.check.Checks;

/**
 * What a sensor model has to reach to pass for faithful to a table.
 *
 * @param leastAgreement share of poses round the obstacle at which model and table agree, in [0, 1]
 * @param greatestRadialMeanM mean over the bearings of |r - T|, metres
 * @param greatestLateralMeanM mean distance of the trace from the shadow's edge, metres
 * @param mostUnreached bearings that the trace may leave out
 */
public record FidelityLimits(
    double leastAgreement,
    double greatestRadialMeanM,
    double greatestLateralMeanM,
    int mostUnreached) {
  /** The shadow sensor's own targets: 3 cm radially, 1 cm beside the edge, no bearing left out. */
  public static final FidelityLimits STANDARD = new FidelityLimits(0.98, 0.03, 0.01, 0);

  /** Checks every figure. */
  public FidelityLimits {
    Checks.share("leastAgreement", leastAgreement);
    if (!(greatestRadialMeanM >= 0 && greatestLateralMeanM >= 0 && mostUnreached >= 0)) {
      throw new IllegalArgumentException(
          "limits "
              + greatestRadialMeanM
              + ", "
              + greatestLateralMeanM
              + ", "
              + mostUnreached
              + " are not all at least 0");
    }
  }
}
