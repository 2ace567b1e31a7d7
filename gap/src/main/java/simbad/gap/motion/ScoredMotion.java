package simbad.gap.motion;

import java.util.Arrays;

/**
 * A set of effects with what it is worth on blocks that it was not fitted to.
 *
 * @param fit to all blocks
 * @param slopes of it
 * @param blocks log density by block, foretold by values that its fold had no part in
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by block, never compared.
record ScoredMotion(MotionFit fit, Slopes slopes, double[] blocks) {
  static ScoredMotion of(MotionSteps given, MotionFit fit) {
    Slopes slopes = new Slopes(given, fit);
    return new ScoredMotion(fit, slopes, slopes.linear().heldOut());
  }

  /** Returns the log density of the whole log, each block foretold by the others. */
  double heldOut() {
    return Arrays.stream(blocks).sum();
  }

  MotionHypothesis hypothesis() {
    return fit.hypothesis();
  }

  /** Returns what it must gain to be as probable as no effect, nats. */
  double costNats() {
    return new PlainFactors(slopes.given().runs()).costNats(hypothesis());
  }

  /** Returns how many values no fold fitted anew, since motion jumps as they change. */
  long jumping() {
    return hypothesis().parameters().stream().filter(p -> p.stepped()).count();
  }
}
