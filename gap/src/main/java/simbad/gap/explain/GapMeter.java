package simbad.gap.explain;

import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.DiagnosedModel;
import simbad.sonar.effect.PingLog;
import simbad.sonar.model.ReadingDistribution;

/**
 * Measures the gap of each ping: twice the mean pinball loss of the 19 predicted quantiles q05 to
 * q95 of the reading, no-echo counted as a range; the continuous ranked probability score by
 * quantiles. Predictions never look at readings.
 */
public final class GapMeter {
  /** Number of predicted quantiles. */
  public static final int QUANTILES = 19;

  private static final int FLOOR_POINTS = 12;
  private static final double LEAST = 1e-6;

  /** Further than any echo: quantiles below it are those of the echoes alone. */
  private static final double BEYOND_M = 1e4;

  private final PingLog log;
  private final double noEchoM;

  /** Creates a meter for a log. */
  public GapMeter(Evidence evidence) {
    log = evidence.log();
    noEchoM = evidence.setup().noEchoM();
  }

  /**
   * The gap of each ping and what it would be on average if the model were right.
   *
   * @param observedM gap of each ping, metres
   * @param expectedM expectation of the same under the model itself, metres
   */
  @SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
  public record Gaps(double[] observedM, double[] expectedM) {}

  /** Measures a hypothesis. */
  public Gaps measure(Evidence evidence, Hypothesis hypothesis) {
    DiagnosedModel model = evidence.model(hypothesis);
    List<ReadingDistribution> forecast = model.forecast(evidence.geometry(model));
    double[] observed = new double[log.size()];
    double[] expected = new double[log.size()];
    IntStream.range(0, log.size())
        .parallel()
        .forEach(
            ping -> {
              double[] quantiles = quantiles(forecast.get(ping));
              double read = log.echo(ping) ? log.rangeM(ping) : noEchoM;
              observed[ping] = loss(quantiles, read);
              expected[ping] = expected(forecast.get(ping), quantiles);
            });
    return new Gaps(observed, expected);
  }

  private double[] quantiles(ReadingDistribution forecast) {
    double[] quantiles = new double[QUANTILES];
    for (int i = 0; i < QUANTILES; i++) {
      quantiles[i] = forecast.quantileM((i + 1) / (QUANTILES + 1.0), noEchoM);
    }
    return quantiles;
  }

  private double expected(ReadingDistribution forecast, double[] quantiles) {
    double silent = forecast.noEchoProbability();
    double sum = silent * loss(quantiles, noEchoM);
    double each = (1 - silent) / FLOOR_POINTS;
    // Echoes and misses apart: a rare one of either costs much and would fall between quantiles.
    for (int i = 0; i < FLOOR_POINTS && each > LEAST; i++) {
      sum += each * loss(quantiles, forecast.quantileM((i + 0.5) * each, BEYOND_M));
    }
    return sum;
  }

  static double loss(double[] quantiles, double read) {
    double sum = 0;
    for (int i = 0; i < quantiles.length; i++) {
      double level = (i + 1) / (quantiles.length + 1.0);
      double over = read - quantiles[i];
      sum += over >= 0 ? level * over : (level - 1) * over;
    }
    return 2 * sum / quantiles.length;
  }
}
