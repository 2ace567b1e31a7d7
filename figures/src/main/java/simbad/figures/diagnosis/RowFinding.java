package simbad.figures.diagnosis;

import java.util.OptionalDouble;
import simbad.sonar.check.Checks;

/**
 * A row of a data set under the simulator as it is and under the diagnosed one.
 *
 * @param obstacle index of the obstacle whose centre is nearest; 0 where there is none
 * @param bearingDeg of the sensor as seen from that obstacle, in [0, 360); 0 where there is none
 * @param distanceM from its centre, metres; empty where there is no obstacle
 * @param offAxisDeg from the heading to that centre, degrees, without sign
 * @param timeS since the run's first ping, seconds
 * @param speedMPerS of the sensor, as believed
 * @param before under the simulator as it is
 * @param after under the diagnosed model
 */
public record RowFinding(
    int obstacle,
    double bearingDeg,
    OptionalDouble distanceM,
    OptionalDouble offAxisDeg,
    double timeS,
    double speedMPerS,
    Fit before,
    Fit after) {
  /** Checks that all are finite. */
  public RowFinding {
    Checks.finite("bearingDeg", bearingDeg);
    Checks.finite("distanceM", distanceM);
    Checks.finite("offAxisDeg", offAxisDeg);
    Checks.finite("timeS", timeS);
    Checks.finite("speedMPerS", speedMPerS);
  }

  /**
   * How a forecast fits the row's reading.
   *
   * @param gapCm centimetres
   * @param pit where in the forecast the reading lies, in [0, 1]: evenly spread when forecasts hold
   * @param residualCm the reading less the median of the expected echoes, centimetres; empty where
   *     no echo was read or none expected
   * @param fromMeanCm the same less the mean of the expected echoes but for the outer tenths: where
   *     ranges come in steps, the median jumps from one to the next
   */
  public record Fit(
      double gapCm, double pit, OptionalDouble residualCm, OptionalDouble fromMeanCm) {
    /** Checks that all are numbers. */
    public Fit {
      Checks.number("gapCm", gapCm);
      Checks.number("pit", pit);
      Checks.number("residualCm", residualCm);
      Checks.number("fromMeanCm", fromMeanCm);
    }
  }
}
