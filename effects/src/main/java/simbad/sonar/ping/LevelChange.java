package simbad.sonar.ping;

/** Under the level law an echo is stronger or weaker than believed; nothing under the other. */
public non-sealed interface LevelChange extends Change {
  /**
   * Returns what is added to the excess of an echo.
   *
   * @param ears by which the sensor hears
   * @param geometry of all pings
   * @param line index of a ping's line of sight to an obstacle
   * @return decibels; 0 changes nothing
   */
  double addedDb(LevelEars ears, Geometry geometry, int line);

  /** Returns by how much more the excess of every echo scatters, decibels, at least 0. */
  default double scatterDb() {
    return 0;
  }

  /**
   * Returns how far an echo may be off for want of knowledge of what the change does to it.
   *
   * @param geometry of all pings
   * @param line index of a ping's line of sight to an obstacle
   * @return decibels, at least 0
   */
  default double deviationDb(Geometry geometry, int line) {
    return 0;
  }
}
