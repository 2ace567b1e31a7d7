package simbad.sonar.scene;

import java.util.Arrays;
import java.util.Optional;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.shape.ThresholdTable;

/**
 * Target strengths that depend on the bearing, with the thresholds that follow from them for those
 * who know thresholds only.
 *
 * @param strength by bearing
 * @param thresholds at which a sensor that looks at the obstacle first loses it, by bearing
 */
public record StrengthDetection(StrengthTable strength, ThresholdTable thresholds)
    implements Detection {
  /** As many as the thesis's tables have; strengths are straight in decibels between theirs. */
  private static final int LEAST_BEARINGS = 72;

  /**
   * Computes the thresholds.
   *
   * @param strength by bearing
   * @param law of the sensor
   * @param maxRangeM of the sensor, metres; no threshold is further
   */
  public static StrengthDetection of(StrengthTable strength, LevelLaw law, double maxRangeM) {
    int size = strength.size() * ((LEAST_BEARINGS - 1) / strength.size() + 1);
    double limitM = Math.min(maxRangeM, ThresholdTable.GREATEST_THRESHOLD_M);
    double[] thresholdM = new double[size];
    Arrays.setAll(
        thresholdM, i -> law.firstLossM(strength.strengthDb(i * Angles.TURN_RAD / size), limitM));
    return new StrengthDetection(strength, ThresholdTable.of(thresholdM));
  }

  @Override
  public double thresholdM(double bearingRad) {
    return thresholds.thresholdM(bearingRad);
  }

  @Override
  public double greatestM() {
    return thresholds.greatestM();
  }

  @Override
  public Optional<ThresholdTable> findTable() {
    return Optional.of(thresholds);
  }
}
