package simbad.sonar.ping;

/** An obstacle answers less often than believed. */
@FunctionalInterface
public non-sealed interface EchoChange extends Change {
  /**
   * Returns what the probability of its echo is multiplied by.
   *
   * @param geometry of all pings
   * @param line index of a ping's line of sight to an obstacle
   * @return in [0, 1]; 1 changes nothing
   */
  double share(Geometry geometry, int line);
}
