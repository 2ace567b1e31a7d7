package simbad.sonar.effect;

/**
 * When an echo is missed, the last reading is repeated for a while.
 *
 * @param pings how often at most; a fraction is the chance of one time more; 0 is neutral
 * @param forS for how long after the last echo at most, seconds
 */
public record StaleReading(double pings, double forS) implements MemoryChange {
  /** The chance that a missed ping repeats a reading that was repeated some times already. */
  double holds(PingLog log, int ping, int times) {
    int echoed = ping - 1 - times;
    if (echoed < log.sequenceStart(ping) || log.timeS(ping) - log.timeS(echoed) > forS) {
      return 0;
    }
    return Math.max(0, Math.min(1, pings - times));
  }
}
