package simbad.sonar.ping;

/** A share of the readings is something else than the echo's range. */
public non-sealed interface MixtureChange extends Change {
  /** Whether it comes before the ranges are scaled and scattered, as a detour of sound does. */
  boolean beforeRange();

  /**
   * Changes the mixture that a reading is drawn from.
   *
   * @param moment the ping, and what was read before it
   * @param mixture of what may be read
   */
  void apply(Moment moment, Mixture mixture);
}
