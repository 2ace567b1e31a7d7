package simbad.sonar.effect;

/**
 * Pings are missed in bursts: a chain of two states, clear and silenced.
 *
 * @param share of the pings that are in a burst, in [0, 1); 0 is neutral
 * @param lengthPings mean length of a burst, at least 1
 * @param depth share of a burst's pings that are missed, in [0, 1]
 */
public record Burst(double share, double lengthPings, double depth) implements MemoryChange {
  /** The probability of being in a burst one ping later. */
  double next(double inBurst) {
    double ends = 1 / lengthPings;
    double begins = Math.min(1, ends * share / (1 - share));
    return inBurst * (1 - ends) + (1 - inBurst) * begins;
  }
}
