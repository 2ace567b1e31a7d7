package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * When an echo is missed, the last reading is repeated for a while.
 *
 * @param pings how often at most; a fraction is the chance of one time more; 0 is neutral
 * @param forS for how long after the last echo at most, seconds; 0 is neutral
 * @param chance that it is repeated each time, in [0, 1]; 0 is neutral
 */
public record StaleReading(double pings, double forS, double chance) implements MemoryChange {
  private static final double FOREVER_S = 1e9;

  /** Checks the figures; NaN is refused. */
  public StaleReading {
    Checks.notNegative("pings", pings);
    Checks.notNegativeOrInfinite("forS", forS);
    Checks.share("chance", chance);
  }

  /** Returns one that repeats a reading so many times. */
  public static StaleReading ofPings(double pings) {
    return new StaleReading(pings, FOREVER_S, 1);
  }

  /** Returns one that repeats a reading for so many seconds. */
  public static StaleReading ofTime(double forS) {
    return new StaleReading(HiddenState.MOST, forS, 1);
  }

  /** Returns one that repeats a reading with such a chance each time. */
  public static StaleReading ofChance(double chance) {
    return new StaleReading(HiddenState.MOST, FOREVER_S, chance);
  }

  @Override
  public boolean isNeutral() {
    return pings == 0 || forS == 0 || chance == 0;
  }

  /**
   * The chance that a missed ping repeats the last echo.
   *
   * @param times how often it was repeated already
   * @param sinceS seconds since the echo
   */
  double holds(int times, double sinceS) {
    return sinceS > forS ? 0 : chance * Math.max(0, Math.min(1, pings - times));
  }
}
