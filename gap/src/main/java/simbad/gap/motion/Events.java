package simbad.gap.motion;

import java.util.Arrays;

/**
 * What happens now and then: steps that are far off. A wheel that slips makes the way shorter; what
 * makes it longer as often is something else.
 *
 * @param shorter times that less way was made than expected
 * @param other times that more was made, or that only the turn was far off
 */
record Events(int shorter, int other) {
  /** Of Gaussian steps one in 400,000 is farther off. */
  private static final double FAR = 4.7;

  /** What follows within this time belongs to the same event. */
  private static final double ONE_EVENT_S = 1.2;

  /** The median size of a Gaussian deviate. */
  private static final double MEDIAN = 0.6745;

  static Events of(Evidence evidence, Fit fit) {
    double[][] expected = evidence.expected(fit.hypothesis().chain());
    double[][] white = new double[Evidence.COMPONENTS][];
    for (int c = 0; c < white.length; c++) {
      white[c] = scaled(new Whitening(evidence, fit.noises()[c], fit.residuals()[c]).white);
    }
    int shorter = 0;
    int other = 0;
    double until = Double.NEGATIVE_INFINITY;
    int run = -1;
    for (int i = 0; i < evidence.size(); i++) {
      boolean far = Math.abs(white[0][i]) > FAR || Math.abs(white[2][i]) > FAR;
      boolean same = evidence.step(i).run() == run && evidence.step(i).from().timeS() < until;
      if (far && !same) {
        boolean less = white[0][i] * Math.signum(expected[0][i]) < -FAR;
        shorter += less ? 1 : 0;
        other += less ? 0 : 1;
      }
      if (far) {
        until = evidence.step(i).to().timeS() + ONE_EVENT_S;
        run = evidence.step(i).run();
      }
    }
    return new Events(shorter, other);
  }

  /** In units in which most of them are standard normal. */
  private static double[] scaled(double[] white) {
    double[] sizes = Arrays.stream(white).map(Math::abs).sorted().toArray();
    double scale = sizes.length == 0 ? 1 : sizes[sizes.length / 2] / MEDIAN;
    return Arrays.stream(white).map(z -> z / scale).toArray();
  }
}
