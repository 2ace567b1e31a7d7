package simbad.gap.diagnosis;

import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;

/**
 * How far a forecast is from a reading: twice the mean pinball loss of the 19 predicted quantiles
 * q05 to q95, no-echo counted as a range. Over many rows it tends to the continuous ranked
 * probability score by quantiles (Gneiting and Raftery 2007, section 4.2).
 */
public final class ForecastGap {
  /** How many quantiles a prediction has. */
  public static final int QUANTILES = 19;

  private ForecastGap() {}

  /**
   * Returns the level of a quantile, from 0.05 to 0.95.
   *
   * @param index from 0 to 18
   */
  public static double level(int index) {
    return (index + 1) / (QUANTILES + 1.0);
  }

  /**
   * Returns the quantiles of a forecast in metres, rising.
   *
   * @param forecast of a reading
   * @param noEchoM the range that a no-echo counts as, metres
   */
  public static double[] quantilesM(ReadingDistribution forecast, double noEchoM) {
    double[] quantiles = new double[QUANTILES];
    for (int i = 0; i < QUANTILES; i++) {
      quantiles[i] = forecast.quantileM(level(i), noEchoM);
    }
    return quantiles;
  }

  /**
   * Returns the gap of a forecast to a reading in metres, at least 0.
   *
   * @param quantilesM the forecast's, as of {@link #quantilesM}
   * @param reading that came
   * @param noEchoM the range that a no-echo counts as, metres
   */
  public static double gapM(double[] quantilesM, Reading reading, double noEchoM) {
    double read = reading instanceof Echo echo ? echo.rangeM() : noEchoM;
    double loss = 0;
    for (int i = 0; i < QUANTILES; i++) {
      double beyond = read - quantilesM[i];
      loss += beyond >= 0 ? level(i) * beyond : (level(i) - 1) * beyond;
    }
    return 2 * loss / QUANTILES;
  }
}
