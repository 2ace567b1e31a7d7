package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Pings are missed in bursts: a chain of two states, clear and silenced.
 *
 * @param share of the pings that are in a burst, in [0, 1); 0 is neutral
 * @param lengthPings mean length of a burst, at least 1; where so many pings are in bursts that
 *     shorter ones would leave no pings between them, bursts are longer
 * @param depth share of a burst's pings that are missed, in [0, 1]; 0 is neutral
 */
public record Burst(double share, double lengthPings, double depth) implements MemoryChange {
  /** On average; what is silent for longer takes up whatever comes and goes. */
  public static final double LONGEST_PINGS = 12;

  /** Checks the figures; NaN is refused. */
  public Burst {
    Checks.share("share", share);
    Checks.atLeast("lengthPings", lengthPings, 1);
    Checks.share("depth", depth);
  }

  @Override
  public boolean isNeutral() {
    return share == 0 || depth == 0;
  }

  /** The chance that a burst ends with a ping. */
  double ends() {
    return Math.min(1 / lengthPings, (1 - share) / share);
  }

  /** The chance that a burst begins after a ping outside; keeps the share. */
  double begins() {
    return ends() * share / (1 - share);
  }
}
