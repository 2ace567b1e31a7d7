package simbad.sonar.effect;

import simbad.sonar.frame.Angles;

/**
 * A reading belongs to an earlier pose: the one of some time ago, between poses in proportion.
 *
 * @param delayS seconds, at least 0; 0 is neutral
 */
public record Latency(double delayS) implements PoseChange {
  @Override
  public int order() {
    return 0;
  }

  @Override
  public PoseMap over(PingLog log) {
    return (ping, pose) -> apply(log, ping, pose);
  }

  private void apply(PingLog log, int ping, TruePose pose) {
    if (delayS == 0) {
      return;
    }
    double then = log.timeS(ping) - delayS;
    int later = ping;
    while (later > log.sequenceStart(ping) && log.timeS(later - 1) >= then) {
      later--;
    }
    // Before the sequence began, the sensor is taken to have stood where it began.
    if (later == log.sequenceStart(ping)) {
      pose.set(log.xM(later), log.zM(later), log.headingRad(later));
    } else {
      between(log, later, then, pose);
    }
  }

  private static void between(PingLog log, int later, double thenS, TruePose pose) {
    int earlier = later - 1;
    double span = log.timeS(later) - log.timeS(earlier);
    double share = span > 0 ? Math.min(1, (thenS - log.timeS(earlier)) / span) : 1;
    double turn = Angles.signed(log.headingRad(later) - log.headingRad(earlier));
    pose.set(
        log.xM(earlier) + share * (log.xM(later) - log.xM(earlier)),
        log.zM(earlier) + share * (log.zM(later) - log.zM(earlier)),
        log.headingRad(earlier) + share * turn);
  }
}
