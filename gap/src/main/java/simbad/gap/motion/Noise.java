package simbad.gap.motion;

/**
 * How one component of the steps scatters about what a model expects. A step's residual is what the
 * robot itself scatters by (Student's t, so that a slip counts as one and bends no fit), and the
 * difference of the tracker's errors at both ends, which makes neighbours pull against each other.
 *
 * <p>What hangs together for longer is left to the blocks that are compared ({@link Linear}): a
 * noise that could last would take up what a wrong scale leaves over, and effects would be fitted
 * to what changes quickly alone.
 *
 * @param tracker standard deviation of the tracker, m or rad; above 0
 * @param process of what the robot scatters by in a second at the mean load; at least 0
 * @param freedom of Student's t
 */
record Noise(double tracker, double process, double freedom) {
  /** Files have so many digits: a track is never known better. */
  static final double LEAST = 2e-5;

  /** Practically Gaussian. */
  static final double GAUSSIAN = 60;

  private static final double NOTHING = 1e-3;

  /** What is believed: a tracker that scatters, and nothing else. */
  static Noise believed(double sigma) {
    return new Noise(Math.max(LEAST, sigma), 0, GAUSSIAN);
  }

  /** Returns a value to start from: both kinds a little, by the mean size of residuals. */
  static Noise start(double size) {
    double each = Math.max(LEAST, size / 2);
    return new Noise(each, each, 8);
  }

  double[] logs() {
    return new double[] {Math.log(tracker), Math.log(Math.max(tracker * NOTHING, process))};
  }

  Noise withLogs(double[] logs) {
    return new Noise(Math.max(LEAST, Math.exp(logs[0])), Math.exp(logs[1]), freedom);
  }

  Noise withFreedom(double degrees) {
    return new Noise(tracker, process, degrees);
  }

  /** Returns the variance of a displacement over some seconds at a load; 1 is the mean load. */
  double variance(double seconds, double load) {
    double heavy = freedom > 2 ? freedom / (freedom - 2) : 3;
    return 2 * tracker * tracker + heavy * process * process * load * seconds;
  }
}
