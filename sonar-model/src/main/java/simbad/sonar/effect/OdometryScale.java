package simbad.sonar.effect;

/**
 * The distances travelled since the start of a run are longer than believed.
 *
 * @param factor true over believed; 1 is neutral
 */
public record OdometryScale(double factor) implements PoseChange {
  @Override
  public int order() {
    return 1;
  }

  @Override
  public PoseMap over(PingLog log) {
    return (ping, pose) -> apply(log, ping, pose);
  }

  private void apply(PingLog log, int ping, TruePose pose) {
    if (factor == 1) {
      return;
    }
    int start = log.sequenceStart(ping);
    pose.set(
        log.xM(start) + factor * (pose.xM() - log.xM(start)),
        log.zM(start) + factor * (pose.zM() - log.zM(start)),
        pose.headingRad());
  }
}
