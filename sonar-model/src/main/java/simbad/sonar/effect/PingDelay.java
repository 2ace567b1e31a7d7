package simbad.sonar.effect;

import simbad.sonar.frame.Angles;

/**
 * A reading belongs to the pose of some pings ago, whatever the time between.
 *
 * @param pings how many, at least 0; between two in proportion; 0 is neutral
 */
public record PingDelay(double pings) implements PoseChange {
  @Override
  public int order() {
    return 0;
  }

  @Override
  public PoseMap over(PingLog log) {
    return (ping, pose) -> apply(log, ping, pose);
  }

  private void apply(PingLog log, int ping, TruePose pose) {
    if (pings == 0) {
      return;
    }
    int start = log.sequenceStart(ping);
    double then = Math.max(start, ping - pings);
    int earlier = (int) then;
    int later = Math.min(ping, earlier + 1);
    double share = then - earlier;
    double turn = Angles.signed(log.headingRad(later) - log.headingRad(earlier));
    pose.set(
        log.xM(earlier) + share * (log.xM(later) - log.xM(earlier)),
        log.zM(earlier) + share * (log.zM(later) - log.zM(earlier)),
        log.headingRad(earlier) + share * turn);
  }
}
