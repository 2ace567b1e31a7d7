package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * One ping, as the bench or the odometry believes it.
 *
 * @param run one continuous recording
 * @param sensor the transducer
 * @param tS time within the run, in seconds
 * @param pose the believed pose of the transducer
 */
public record Row(String run, String sensor, double tS, Pose pose) {
  /** Refuses what is no such thing. */
  public Row {
    Checks.finite("time", tS);
  }
}
