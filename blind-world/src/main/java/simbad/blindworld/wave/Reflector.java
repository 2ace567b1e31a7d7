package simbad.blindworld.wave;

import simbad.blindworld.world.Pose;

/** Something that sends an echo back. */
public interface Reflector {

  /**
   * Its echo without the burst's length: bare arrivals.
   *
   * @param pose where the sonar is and looks
   * @param medium the sonar in its air
   * @param tS time within the run
   */
  Trace arrivals(Pose pose, Medium medium, double tS);

  /** How much its level scatters from ping to ping by itself, in decibels. */
  default double restlessDb() {
    return 0;
  }
}
