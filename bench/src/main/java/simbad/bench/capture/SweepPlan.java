package simbad.bench.capture;

/**
 * How a sweep is done.
 *
 * @param bearings how many, evenly round the obstacle from 0; at least 3
 * @param pings at each distance, at least 1
 * @param misses so many of them make the distance one at which the echo is lost; in [1, pings]
 * @param stepM between the distances tried, metres, above 0
 * @param nearM nearest distance that is tried, metres, at least stepM
 * @param farM furthest distance that is tried, metres, above nearM, at most 100
 */
public record SweepPlan(
    int bearings, int pings, int misses, double stepM, double nearM, double farM) {
  static final int MOST_BEARINGS = 3600;
  static final double FURTHEST_M = 100;

  /** Ten pings every 2 cm from 4 cm to 3.4 m, lost when 5 are missed. */
  public static SweepPlan ofBearings(int bearings) {
    return new SweepPlan(bearings, 10, 5, 0.02, 0.04, 3.4);
  }

  /**
   * Returns the same with another decision.
   *
   * @param count of pings at each distance, at least 1
   * @param lostFrom so many misses, in [1, count]
   * @param everyM between distances, metres, above 0
   */
  public SweepPlan with(int count, int lostFrom, double everyM) {
    return new SweepPlan(bearings, count, lostFrom, everyM, Math.max(nearM, everyM), farM);
  }

  /** Checks that every number is in its interval. */
  public SweepPlan {
    require(bearings >= 3 && bearings <= MOST_BEARINGS, "bearings", bearings, "[3, 3600]");
    require(pings >= 1 && pings <= 10_000, "pings", pings, "[1, 10000]");
    require(misses >= 1 && misses <= pings, "misses", misses, "[1, pings = " + pings + "]");
    require(stepM > 0 && stepM <= 1, "stepM", stepM, "(0, 1]");
    require(nearM >= stepM && nearM <= FURTHEST_M, "nearM", nearM, "[stepM = " + stepM + ", 100]");
    require(farM > nearM && farM <= FURTHEST_M, "farM", farM, "(nearM = " + nearM + ", 100]");
  }

  private static void require(boolean holds, String name, double value, String permitted) {
    if (!holds) {
      throw new IllegalArgumentException(name + " = " + value + " is not in " + permitted);
    }
  }

  /** Tells whether the echo counts as lost at a level: k misses of n. */
  boolean isLost(Level level) {
    return level.pings() - level.heard() >= misses;
  }

  boolean isWhole(Level level) {
    return level.pings() >= pings;
  }

  /**
   * Returns a bearing in degrees.
   *
   * @param index in [0, bearings)
   */
  public double bearingDeg(int index) {
    return index * 360.0 / bearings;
  }
}
