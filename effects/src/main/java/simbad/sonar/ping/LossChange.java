package simbad.sonar.ping;

/** A whole ping is missed now and then, whatever answers it. */
@FunctionalInterface
public non-sealed interface LossChange extends Change {
  /**
   * Returns the share of pings whose echoes are lost.
   *
   * @param geometry of all pings
   * @param ping whose loss it is
   * @return in [0, 1]; 0 changes nothing
   */
  double share(Geometry geometry, int ping);
}
