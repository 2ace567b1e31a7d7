package simbad.sonar.effect;

/** The sensor is not where it is believed to be, or does not look where it is believed to look. */
public non-sealed interface PoseChange extends Change {
  /** Which pose changes come first: what replaces a pose, then what bends the way to it. */
  int order();

  /**
   * Prepares the change for the pings of a log.
   *
   * @param log all pings
   * @return what moves each ping's pose
   */
  PoseMap over(PingLog log);

  /** Moves the poses of one log's pings to where they really are. */
  @FunctionalInterface
  interface PoseMap {
    /**
     * Moves a pose.
     *
     * @param ping whose pose it is
     * @param pose the believed pose, or what changes before this one made of it
     */
    void apply(int ping, TruePose pose);
  }
}
