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
  /** So many quantiles make a forecast: q05 to q95. */
  public static final int QUANTILES = 19;

  private PinballLoss() {}

  /**
   * Returns the level of a quantile of a forecast, from 0.05 to 0.95.
   *
   * @param index from 0 to 18
   */
  public static double level(int index) {
    return (index + 1) / (QUANTILES + 1.0);
  }

  /**
   * Returns the loss, in the unit of the value, at least 0.
   *
   * @param level of the quantile, in (0, 1)
   * @param beyond what was seen less the quantile; negative where it falls short
   */
  public static double of(double level, double beyond) {
    return beyond >= 0 ? level * beyond : (level - 1) * beyond;
  }

  /**
   * Returns the CRPS of a forecast by its quantiles: twice their mean loss, in the unit of the
   * value, at least 0.
   *
   * @param quantiles q05 to q95
   * @param value that came
   */
  public static double crps(double[] quantiles, double value) {
    double loss = 0;
    for (int i = 0; i < QUANTILES; i++) {
      loss += of(level(i), value - quantiles[i]);
    }
    return 2 * loss / QUANTILES;
  }
}
