package simbad.sonar.scene;

/** At which distance from an obstacle's centre a sensor loses it, by the sensor's bearing. */
public sealed interface Detection permits TableDetection, UniformDetection {
  /**
   * Returns the threshold.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
   * @return metres, at least 0; at 0 the obstacle is never heard
   */
  double thresholdM(double bearingRad);

  /** Returns the greatest threshold over all bearings in metres. */
  double greatestM();
}
