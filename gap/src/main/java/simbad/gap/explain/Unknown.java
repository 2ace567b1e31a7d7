package simbad.gap.explain;

import java.util.List;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Burst;
import simbad.sonar.effect.Change;

/**
 * How probable it is that something is at work that the best set of effects does not account for.
 */
public final class Unknown {
  /** How many of the greatest misfits count. */
  static final int TOP = 5;

  /** Mean of the five greatest misfits at which it is as probable as not, and how fast it turns. */
  private static final double EVEN = 4.4;

  private static final double WIDTH = 0.35;

  /**
   * Of logs that were checked and fitted well, so many held what has no name; of those that fitted
   * badly, so many did (docs/method/gap.md).
   */
  private static final double LEAST = 0.015;

  private static final double MOST = 0.9;

  /** A gap that is left and is a smaller share of the gap before does not matter. */
  private static final double SMALL_SHARE = 0.05;

  private static final double PRACTICAL_M = 0.002;

  /** Three effects at once are rarer than one thing that has no name. */
  private static final double THIRD = 2;

  /** In 711 checked worlds the longest bursts there may be were never bursts (21 of 21). */
  private static final double TOO_LONG = 6;

  private static final double NEARLY = 0.99;

  private Unknown() {}

  /**
   * Estimates the probability.
   *
   * @param misfit of the best set
   * @param gain of the best set
   * @param best the best set of effects
   * @param clumping by how much readings hang together; 1 for independent ones
   */
  public static double probability(Misfit misfit, Gain gain, Hypothesis best, double clumping) {
    int effects = best.forms().size();
    double off = misfit.top(TOP) / Math.sqrt(clumping);
    double logit = (off - EVEN) / WIDTH + (effects > 2 ? THIRD : 0);
    double left = gain.afterM() - mean(gain.after().expectedM());
    boolean small = left < Math.max(PRACTICAL_M, SMALL_SHARE * (gain.beforeM() - gain.floorM()));
    // Bursts expect so much of chance that next to nothing seems left, whatever they stand for.
    if (small && effects > 0 && best.changes().stream().noneMatch(Burst.class::isInstance)) {
      logit -= THIRD;
    }
    if (best.changes().stream().anyMatch(Unknown::isLongerThanBursts)) {
      logit += TOO_LONG;
    }
    return LEAST + (MOST - LEAST) / (1 + Math.exp(-logit));
  }

  private static boolean isLongerThanBursts(Change change) {
    return change instanceof Burst burst && burst.lengthPings() > NEARLY * Burst.LONGEST_PINGS;
  }

  private static double mean(double[] values) {
    return java.util.Arrays.stream(values).average().orElse(0);
  }

  /** Returns the slices that are most off, for the report. */
  public static List<Misfit.Slice> worst(Misfit misfit) {
    return misfit.slices().stream().limit(TOP).toList();
  }
}
