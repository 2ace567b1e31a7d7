package simbad.sonar.ping;

/** The sensor is not where it is believed to be, or does not look where it is believed to look. */
public non-sealed interface PoseChange extends Change {
  @Override
  default boolean changesGeometry() {
    return true;
  }

  /**
   * Which pose changes come first: what bends the way, then what puts an earlier pose in the place
   * of the last one, then what turns the sensor on its mount.
   */
  int order();

  /**
   * By how many seconds a believed pose is written late. Where a log says where the sensor was so
   * much later, that pose is taken, and its track is left out; a track knows the past alone.
   */
  default double aheadS() {
    return 0;
  }

  /**
   * Starts to follow one sensor through one run.
   *
   * @param sensor label of the sensor
   * @param runStartS time of the first ping of the run, over all its sensors, seconds
   */
  Track start(String sensor, double runStartS);

  /** Follows one sensor through one run, ping by ping. */
  @FunctionalInterface
  interface Track {
    /** Leaves every pose as it is. */
    Track STILL = (timeS, pose) -> {};

    /**
     * Moves the pose of the next ping.
     *
     * @param timeS of the ping; never decreases
     * @param pose the believed pose, or what changes before this one made of it
     */
    void next(double timeS, TruePose pose);
  }
}
