package simbad.sonar.scene;

import java.util.Optional;
import simbad.sonar.shape.ThresholdTable;

/** At which distance from an obstacle's centre a sensor loses it, by the sensor's bearing. */
public sealed interface Detection permits TableDetection, UniformDetection, StrengthDetection {
  /**
   * Returns the threshold.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
   * @return metres, at least 0; at 0 the obstacle is never heard
   */
  double thresholdM(double bearingRad);

  /** Returns the greatest threshold over all bearings in metres. */
  double greatestM();

  /** Returns the table of thresholds; none where they are alike all round. */
  Optional<ThresholdTable> findTable();
}
