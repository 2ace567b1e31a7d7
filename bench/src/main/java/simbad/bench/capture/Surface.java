package simbad.bench.capture;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.check.Checks;

/**
 * Where the surface of the obstacle can be, given where its axis is: what a reading and a distance
 * on the tape must agree on.
 *
 * @param reachM how far the obstacle's outline reaches from its axis, metres, at least 0
 * @param ranging makes ranges of times
 */
public record Surface(double reachM, Ranging ranging) {
  /** The speed of sound in air that is 25 degrees warmer or colder than thought, and a little. */
  private static final double RANGE_SHARE = 0.05;

  /** A tape that sags, the thesis's steps of 2 cm. */
  private static final double TAPE_M = 0.03;

  /** Checks the reach. */
  public Surface {
    Checks.notNegative("reachM", reachM);
  }

  /**
   * Finds the range that contradicts a distance: the first echo's, when no echo's is possible.
   *
   * @param pings any number
   * @param axisM distance of the axis as it was read from the tape, metres
   * @return metres; empty without echoes, or when one of them can be the obstacle's
   */
  OptionalDouble findContradiction(List<FrameLine.Ping> pings, double axisM) {
    double[] rangesM =
        pings.stream()
            .filter(ping -> ping.status() == PingStatus.ECHO)
            .map(FrameLine.Ping::echoUs)
            .flatMapToInt(OptionalInt::stream)
            .mapToDouble(ranging::rangeM)
            .toArray();
    for (double rangeM : rangesM) {
      if (Math.abs(rangeM - axisM) <= reachM + TAPE_M + RANGE_SHARE * axisM) {
        return OptionalDouble.empty();
      }
    }
    return rangesM.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(rangesM[0]);
  }
}
