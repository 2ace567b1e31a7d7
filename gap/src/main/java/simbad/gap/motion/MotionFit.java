package simbad.gap.motion;

/**
 * A hypothesis with its best values.
 *
 * @param hypothesis with the values
 * @param residuals by component and step
 * @param noises by component
 * @param score log density of the whole log
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by step, never compared.
record MotionFit(MotionHypothesis hypothesis, double[][] residuals, Noise[] noises, double score) {
  /** What chance gains per value that is fitted. */
  private static final double NATS_PER_VALUE = 0.5;

  /** Returns the residuals made white, by component. */
  Whitening[] white(MotionSteps given) {
    Whitening[] white = new Whitening[residuals.length];
    for (int c = 0; c < white.length; c++) {
      white[c] = new Whitening(given, noises[c], residuals[c]);
    }
    return white;
  }

  /** Returns the score less what chance alone would have gained. */
  double promise() {
    return score - NATS_PER_VALUE * hypothesis.values().length;
  }
}
