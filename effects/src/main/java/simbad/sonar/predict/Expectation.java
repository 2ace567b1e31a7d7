package simbad.sonar.predict;

/** What a model expected of each ping of a log just before its reading came. */
public final class Expectation {
  private final double[] echo;
  private final double[] below;
  private final double[] reading;

  /** Creates room for the pings of a log. */
  Expectation(int pings) {
    echo = new double[pings];
    below = new double[pings];
    reading = new double[pings];
  }

  /** Returns the probability of an echo, for each ping. */
  public double[] echo() {
    return echo;
  }

  /**
   * Returns the probability of an echo below the step that was read; of no meaning at a no-echo.
   */
  public double[] below() {
    return below;
  }

  /** Returns the probability of what was read: of no echo, or of the step. */
  public double[] reading() {
    return reading;
  }
}
