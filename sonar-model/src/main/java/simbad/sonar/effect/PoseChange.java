package simbad.sonar.effect;

/** The sensor is not where it is believed to be, or does not look where it is believed to look. */
public non-sealed interface PoseChange extends Change {
  /** Which pose changes come first: what replaces a pose, then what bends the way to it. */
  int order();

  /**
   * Moves a pose to where it really is.
   *
   * @param log all pings
   * @param ping whose pose it is
   * @param pose the believed pose, or what changes before this one made of it
   */
  void apply(PingLog log, int ping, TruePose pose);
}
