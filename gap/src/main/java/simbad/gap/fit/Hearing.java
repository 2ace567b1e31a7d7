package simbad.gap.fit;

import java.util.List;
import simbad.sonar.effect.OrientationShadow;

/**
 * What each reading is worth when an obstacle is heard and when it is not: with the chance of being
 * heard between, a reading is a mixture of the two, whatever else is at work.
 */
final class Hearing {
  /** Further than any ping. */
  private static final double ALWAYS_M = 100;

  private final double[] silent;
  private final double[] heard;

  /**
   * Asks a hypothesis.
   *
   * @param clues of the hypothesis
   * @param others thresholds of other obstacles
   * @param obstacle by its index
   */
  Hearing(LogClues clues, List<OrientationShadow> others, int obstacle) {
    silent = clues.likelihood(others, obstacle, 0);
    heard = clues.likelihood(others, obstacle, ALWAYS_M);
  }

  /** Log probability of a reading if the obstacle is heard with a chance, in [0, 1]. */
  double logLikelihood(int ping, double chance) {
    return Math.log(silent[ping] + chance * (heard[ping] - silent[ping]));
  }
}
