package simbad.sonar.effect;

/**
 * The believed heading drifts with the time since the start of a run.
 *
 * @param radPerS true less believed heading, for each second; 0 is neutral
 * @param reckoned whether places were reckoned with the drifting heading, so that the way is bent
 */
public record HeadingDrift(double radPerS, boolean reckoned) implements PoseChange {
  @Override
  public int order() {
    return 2;
  }

  @Override
  public void apply(PingLog log, int ping, TruePose pose) {
    if (radPerS == 0) {
      return;
    }
    double since = log.timeS(ping) - log.runStartS(ping);
    if (reckoned) {
      bend(log, ping, pose);
    }
    pose.turn(radPerS * since);
  }

  /** Lays the way from the start again, each piece of it turned by the drift of its time. */
  private void bend(PingLog log, int ping, TruePose pose) {
    int start = log.sequenceStart(ping);
    double x = log.xM(start);
    double z = log.zM(start);
    for (int i = start + 1; i <= ping; i++) {
      double angle = radPerS * ((log.timeS(i) + log.timeS(i - 1)) / 2 - log.runStartS(ping));
      double dx = log.xM(i) - log.xM(i - 1);
      double dz = log.zM(i) - log.zM(i - 1);
      x += dx * Math.cos(angle) + dz * Math.sin(angle);
      z += dz * Math.cos(angle) - dx * Math.sin(angle);
    }
    pose.set(x + pose.xM() - log.xM(ping), z + pose.zM() - log.zM(ping), pose.headingRad());
  }
}
