package simbad.gap.motion;

/**
 * By how much motion scatters more than believed: over half a second, as a share of what the robot
 * does in it (root of the mean square).
 *
 * @param along of the way
 * @param turn of the turns
 * @param seesAlong whether the tracker would show the way scatter as much as the turns do
 * @param seesTurn the same of the turns
 */
record Scatter(double along, double turn, boolean seesAlong, boolean seesTurn) {
  /** A scatter of less than a fiftieth averages out before it matters to anybody. */
  static final double MATTERS = 0.02;

  private static final double OVER_S = 0.5;

  /** Motors and floors that are unsteady are so in both; a half to all of the other is usual. */
  private static final double ONE_SIDED = 0.3;

  private static final int ALONG = 0;
  private static final int TURN = 2;

  static Scatter of(MotionSteps given, MotionFit fit, Noise[] believed) {
    double[][] expected = given.expected(fit.hypothesis().chain());
    double way = rate(given, expected[ALONG]) * OVER_S;
    double angle = rate(given, expected[TURN]) * OVER_S;
    double along = more(fit.noises()[ALONG], believed[ALONG]) / way;
    double turn = more(fit.noises()[TURN], believed[TURN]) / angle;
    return new Scatter(
        along,
        turn,
        turn * way > Math.sqrt(2) * fit.noises()[ALONG].tracker(),
        along * angle > Math.sqrt(2) * fit.noises()[TURN].tracker());
  }

  /** Root mean square of a rate, never 0. */
  private static double rate(MotionSteps given, double[] expected) {
    double square = 0;
    double seconds = 0;
    for (int i = 0; i < expected.length; i++) {
      square += expected[i] * expected[i] / given.durationS(i);
      seconds += given.durationS(i);
    }
    return Math.max(1e-9, Math.sqrt(square / seconds));
  }

  private static double more(Noise found, Noise believed) {
    return Math.sqrt(Math.max(0, own(found) - own(believed)));
  }

  /** What the robot itself scatters by, squared. */
  private static double own(Noise noise) {
    return noise.variance(OVER_S, 1) - 2 * noise.tracker() * noise.tracker();
  }

  double greatest() {
    return Math.max(along, turn);
  }

  boolean matters() {
    return greatest() >= MATTERS;
  }

  /** Tells whether one scatters and the other, which would be seen, does hardly. */
  boolean isOneSided() {
    boolean alongAlone = seesTurn && turn < ONE_SIDED * along;
    boolean turnAlone = seesAlong && along < ONE_SIDED * turn;
    return matters() && (alongAlone || turnAlone);
  }
}
