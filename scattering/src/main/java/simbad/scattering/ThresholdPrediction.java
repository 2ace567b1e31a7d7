package simbad.scattering;

import java.util.Arrays;
import simbad.sonar.level.Air;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/**
 * The thresholds that are to be expected of a cross-section.
 *
 * @param table predicted, metres, in steps of 1 mm
 * @param band of {@value FittedReceiver#COVERAGE_PERCENT} % of what was calibrated on
 */
public record ThresholdPrediction(ThresholdTable table, ThresholdBand band) {
  private static final double STEPS_PER_M = 1000;

  /**
   * Predicts a table.
   *
   * @param backscatter how the cross-section echoes
   * @param air between sensor and obstacle
   * @param limits of the sensor: blanking and time-out
   * @param calibration of the sensor
   */
  public static ThresholdPrediction of(
      Backscatter backscatter, Air air, RangeLimits limits, FittedReceiver calibration) {
    SonarEquation equation = SonarEquation.of(calibration.receiver(), air, limits);
    return new ThresholdPrediction(
        table(equation, backscatter, 0),
        new ThresholdBand(
            table(equation, backscatter, -calibration.spreadDb()),
            table(equation, backscatter, calibration.spreadDb())));
  }

  private static ThresholdTable table(
      SonarEquation equation, Backscatter backscatter, double raisedDb) {
    return ThresholdTable.of(
        Arrays.stream(equation.thresholdsM(backscatter, raisedDb))
            .map(metres -> Math.round(metres * STEPS_PER_M) / STEPS_PER_M)
            .toArray());
  }
}
