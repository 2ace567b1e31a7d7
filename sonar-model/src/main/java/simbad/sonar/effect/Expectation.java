package simbad.sonar.effect;

/**
 * What a model expected of each ping of a log just before its reading came.
 *
 * @param echo probability of an echo, for each ping
 * @param below probability of an echo below the step that was read; of no meaning at a no-echo
 * @param reading probability of what was read: of no echo, or of the step
 */
public record Expectation(double[] echo, double[] below, double[] reading) {
  /** Creates room for the pings of a log. */
  static Expectation of(int pings) {
    return new Expectation(new double[pings], new double[pings], new double[pings]);
  }
}
