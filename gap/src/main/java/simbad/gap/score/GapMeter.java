package simbad.gap.score;

import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.ForecastGap;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.check.Checks;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;

/**
 * Measures the gap of each ping, as {@link ForecastGap} says. Predictions never look at readings.
 */
public final class GapMeter {
  private static final int FLOOR_POINTS = 12;

  private final PingLog log;
  private final double noEchoM;

  /** Creates a meter for a log. */
  public GapMeter(CalibratedLog given) {
    log = given.log();
    noEchoM = given.setup().noEchoM();
  }

  /**
   * The gap of each ping and what it would be on average if the model were right.
   *
   * @param observedM gap of each ping, metres
   * @param expectedM expectation of the same under the model itself, metres
   */
  @SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
  public record Gaps(double[] observedM, double[] expectedM) {
    /** Refuses what is no number. */
    public Gaps {
      Checks.numbers("observedM", observedM);
      Checks.numbers("expectedM", expectedM);
    }
  }

  /** Measures a hypothesis. */
  public Gaps measure(CalibratedLog given, Hypothesis hypothesis) {
    ChangedModel model = given.model(hypothesis);
    List<ReadingDistribution> forecast = given.forecast(model);
    double[] observed = new double[log.size()];
    double[] expected = new double[log.size()];
    IntStream.range(0, log.size())
        .parallel()
        .forEach(
            ping -> {
              double[] quantiles = ForecastGap.quantilesM(forecast.get(ping), noEchoM);
              double read = log.echo(ping) ? log.rangeM(ping) : noEchoM;
              observed[ping] = ForecastGap.gapM(quantiles, read);
              expected[ping] =
                  forecast
                      .get(ping)
                      .expected(range -> ForecastGap.gapM(quantiles, range), noEchoM, FLOOR_POINTS);
            });
    return new Gaps(observed, expected);
  }
}
