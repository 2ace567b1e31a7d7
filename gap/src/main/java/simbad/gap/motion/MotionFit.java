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
  /** Returns the residuals made white, by component. */
  Whitening[] white(MotionSteps given) {
    Whitening[] white = new Whitening[residuals.length];
    for (int c = 0; c < white.length; c++) {
      white[c] = new Whitening(given, noises[c], residuals[c]);
    }
    return white;
  }

  /**
   * Returns the score less what other logs would miss of it (Takeuchi 1976).
   *
   * @param perValue by how many times blocks pull apart more than by chance
   */
  double promise(double perValue) {
    return score - perValue * hypothesis.values().length;
  }
}
