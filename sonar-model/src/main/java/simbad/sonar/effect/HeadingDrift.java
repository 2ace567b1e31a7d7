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
  public PoseMap over(PingLog log) {
    if (radPerS == 0) {
      return (ping, pose) -> {};
    }
    double[] x = new double[log.size()];
    double[] z = new double[log.size()];
    if (reckoned) {
      bend(log, x, z);
    }
    return (ping, pose) ->
        pose.set(pose.xM() + x[ping], pose.zM() + z[ping], pose.headingRad() + drift(log, ping));
  }

  private double drift(PingLog log, int ping) {
    return radPerS * (log.timeS(ping) - log.runStartS(ping));
  }

  /** Lays each way from its start again, each piece turned by the drift of its time. */
  private void bend(PingLog log, double[] x, double[] z) {
    for (int i = 1; i < log.size(); i++) {
      if (log.sequenceStart(i) == i) {
        continue;
      }
      double angle = (drift(log, i) + drift(log, i - 1)) / 2;
      double dx = log.xM(i) - log.xM(i - 1);
      double dz = log.zM(i) - log.zM(i - 1);
      x[i] = x[i - 1] + dx * Math.cos(angle) + dz * Math.sin(angle) - dx;
      z[i] = z[i - 1] + dz * Math.cos(angle) - dx * Math.sin(angle) - dz;
    }
  }
}
