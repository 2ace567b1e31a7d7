package simbad.sonar.effect;

/**
 * The sensor looks to one side of its believed heading.
 *
 * @param turnRad by which it is turned, counter-clockwise seen from above; 0 is neutral
 * @param sensor index of the one sensor that does, {@link #EVERY} for all
 */
public record BeamMisalignment(double turnRad, int sensor) implements PoseChange {
  /** In the place of a sensor's index: all of them. */
  public static final int EVERY = -1;

  @Override
  public int order() {
    return 3;
  }

  @Override
  public PoseMap over(PingLog log) {
    return (ping, pose) -> apply(log, ping, pose);
  }

  private void apply(PingLog log, int ping, TruePose pose) {
    if (sensor == EVERY || log.sensor(ping) == sensor) {
      pose.turn(turnRad);
    }
  }
}
