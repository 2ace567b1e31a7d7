package simbad.sonar.ping;

/** An obstacle is lost at another distance than believed. */
@FunctionalInterface
public non-sealed interface ThresholdChange extends Change {
  /**
   * Returns what the threshold is multiplied by.
   *
   * @param geometry of all pings
   * @param line index of a ping's line of sight to an obstacle
   * @return at least 0; 1 changes nothing
   */
  double factor(Geometry geometry, int line);
}
