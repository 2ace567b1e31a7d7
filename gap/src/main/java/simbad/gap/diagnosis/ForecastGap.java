package simbad.gap.diagnosis;

import java.util.stream.IntStream;
import simbad.motion.forecast.PinballLoss;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;

/**
 * How far a forecast is from a reading, the CRPS by quantiles: twice the mean {@link PinballLoss}
 * of the 19 predicted quantiles q05 to q95, no-echo counted as a range. Over many rows it tends to
 * the continuous ranked probability score by quantiles (Gneiting and Raftery 2007, section 4.2).
 */
public final class ForecastGap {
  private static final double[] LEVELS =
      IntStream.range(0, PinballLoss.QUANTILES).mapToDouble(PinballLoss::level).toArray();

  private ForecastGap() {}

  /**
   * Returns the quantiles of a forecast in metres, rising.
   *
   * @param forecast of a reading
   * @param noEchoM the range that a no-echo counts as, metres
   */
  public static double[] quantilesM(ReadingDistribution forecast, double noEchoM) {
    return forecast.quantilesM(LEVELS, noEchoM);
  }

  /**
   * Returns the gap of a forecast to a reading in metres, at least 0.
   *
   * @param quantilesM the forecast's, as of {@link #quantilesM}
   * @param reading that came
   * @param noEchoM the range that a no-echo counts as, metres
   */
  public static double gapM(double[] quantilesM, Reading reading, double noEchoM) {
    return gapM(quantilesM, reading instanceof Echo echo ? echo.rangeM() : noEchoM);
  }

  /**
   * Returns the gap of a forecast to a range in metres, at least 0.
   *
   * @param quantilesM the forecast's, as of {@link #quantilesM}
   * @param read what was read, metres; for no echo, the range that it counts as
   */
  public static double gapM(double[] quantilesM, double read) {
    return PinballLoss.crps(quantilesM, read);
  }
}
