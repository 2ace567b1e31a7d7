package simbad.sonar.effect;

import java.util.Arrays;

/** How probable it is that the last reading has been repeated 0, 1, 2, ... times. */
final class HoldState {
  /** A reading that is repeated more often than this is not waited for. */
  static final int MOST = 40;

  private final double[] repeated = new double[MOST + 1];
  private int last = -1;

  /** Nothing has been read that could be repeated. */
  void start() {
    Arrays.fill(repeated, 0, last + 1, 0);
    last = -1;
  }

  int last() {
    return last;
  }

  double probability(int times) {
    return repeated[times];
  }

  /** How probable it is that a miss repeats the last reading. */
  double repeats(StaleReading stale, PingLog log, int ping) {
    double sum = 0;
    for (int times = 0; times <= last; times++) {
      sum += repeated[times] * stale.holds(log, ping, times);
    }
    return sum;
  }

  /**
   * Goes on by a ping.
   *
   * @param echo how probable it is that it was answered
   * @param missed what a repeating state's probability is multiplied by as it goes on
   */
  void advance(StaleReading stale, PingLog log, int ping, double echo, double missed) {
    int top = Math.min(last, MOST - 1);
    for (int times = top; times >= 0; times--) {
      repeated[times + 1] = repeated[times] * stale.holds(log, ping, times) * missed;
    }
    repeated[0] = echo;
    last = top + 1;
  }
}
