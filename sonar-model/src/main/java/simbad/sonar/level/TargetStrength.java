package simbad.sonar.level;

import simbad.sonar.check.Checks;
import simbad.sonar.shape.ThresholdTable;

/** How strongly a target answers, by the bearing of the sensor. Implementations are immutable. */
public interface TargetStrength {
  /**
   * Returns the strength.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
   * @return decibels; negative infinity where nothing ever answers
   */
  double strengthDb(double bearingRad);

  /** Returns a strength that none of the bearings exceeds, decibels. */
  double greatestDb();

  /**
   * The strength that a threshold stands for: on the axis the excess is 0 dB there.
   *
   * @param thresholds distances at which the target is just lost, by bearing
   * @param believed the law under which they were measured
   */
  static TargetStrength ofThresholds(ThresholdTable thresholds, LevelLaw believed) {
    double greatestDb = believed.greatestStrengthDb(thresholds.greatestM());
    return new TargetStrength() {
      @Override
      public double strengthDb(double bearingRad) {
        return believed.strengthDb(thresholds.thresholdM(bearingRad));
      }

      @Override
      public double greatestDb() {
        return greatestDb;
      }
    };
  }

  /**
   * The same strength all round.
   *
   * @param strengthDb decibels; negative infinity for a target that never answers
   */
  static TargetStrength uniform(double strengthDb) {
    Checks.number("strengthDb", strengthDb);
    return new TargetStrength() {
      @Override
      public double strengthDb(double bearingRad) {
        return strengthDb;
      }

      @Override
      public double greatestDb() {
        return strengthDb;
      }
    };
  }
}
