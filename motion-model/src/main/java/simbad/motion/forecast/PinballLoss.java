package simbad.motion.forecast;

/**
 * The loss of a predicted quantile, also called quantile loss: what lies beyond it counts by its
 * level, what falls short by the rest. On average it is least for the true quantile. Twice its mean
 * over many levels tends to the CRPS, the continuous ranked probability score.
 *
 * <p>References: Gneiting and Raftery, Strictly proper scoring rules, prediction, and estimation,
 * 2007, section 4.2.
 */
public final class PinballLoss {
  private PinballLoss() {}

  /**
   * Returns the loss, in the unit of the value, at least 0.
   *
   * @param level of the quantile, in (0, 1)
   * @param beyond what was seen less the quantile; negative where it falls short
   */
  public static double of(double level, double beyond) {
    return beyond >= 0 ? level * beyond : (level - 1) * beyond;
  }
}
