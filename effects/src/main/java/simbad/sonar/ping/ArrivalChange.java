package simbad.sonar.ping;

/** Something answers that is not in the scene. */
@FunctionalInterface
public non-sealed interface ArrivalChange extends Change {
  /**
   * Adds what answers.
   *
   * @param moment the ping, and what was read before it
   * @param arrivals takes what answers
   */
  void add(Moment moment, Arrivals arrivals);

  /** Returns whether what answers depends on where the sensor is and looks. */
  default boolean hangsOnPose() {
    return true;
  }
}
