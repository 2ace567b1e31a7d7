package simbad.gap.motion;

/**
 * How one component of the steps scatters about what a model expects. A step's residual is what the
 * robot itself scatters by (Student's t, so that a slip counts as one and bends no fit), an error
 * of its rate that lasts for a while, and the difference of the tracker's errors at both ends. The
 * last makes neighbours pull against each other, the second makes them hang together.
 *
 * @param tracker standard deviation of the tracker, m or rad; above 0
 * @param process of what the robot scatters by in a second at the mean load; at least 0
 * @param rate of the lasting error, m/s or rad/s; at least 0
 * @param lastsS how long the lasting error lasts
 * @param freedom of Student's t
 */
record Noise(double tracker, double process, double rate, double lastsS, double freedom) {
  /** Files have so many digits: a track is never known better. */
  static final double LEAST = 2e-5;

  /** Practically Gaussian. */
  static final double GAUSSIAN = 60;

  private static final double NOTHING = 1e-3;

  /** What is believed: a tracker that scatters, and nothing else. */
  static Noise believed(double sigma) {
    return new Noise(Math.max(LEAST, sigma), 0, 0, 2, GAUSSIAN);
  }

  /** Returns a value to start from: both kinds a little, by the mean size of residuals. */
  static Noise start(double size) {
    double each = Math.max(LEAST, size / 2);
    return new Noise(each, each, each, 2, 8);
  }

  double[] logs() {
    double least = tracker * NOTHING;
    return new double[] {
      Math.log(tracker), Math.log(Math.max(least, process)), Math.log(Math.max(least, rate))
    };
  }

  Noise withLogs(double[] logs) {
    double scale = Math.max(LEAST, Math.exp(logs[0]));
    return new Noise(scale, Math.exp(logs[1]), Math.exp(logs[2]), lastsS, freedom);
  }

  Noise withLasting(double seconds) {
    return new Noise(tracker, process, rate, seconds, freedom);
  }

  Noise withFreedom(double degrees) {
    return new Noise(tracker, process, rate, lastsS, degrees);
  }

  /** Returns the variance of a displacement over some seconds at the mean load. */
  double variance(double seconds) {
    double kept = Math.exp(-seconds / lastsS);
    double lasting =
        2 * rate * rate * lastsS * lastsS * (seconds / lastsS - 1 + kept); // of an integrated rate
    double heavy = freedom > 2 ? freedom / (freedom - 2) : 3;
    return 2 * tracker * tracker + heavy * process * process * seconds + lasting;
  }
}
