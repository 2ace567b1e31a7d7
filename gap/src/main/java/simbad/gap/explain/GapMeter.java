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

  private static final int FLOOR_POINTS = 20;

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
    if (quantiles[0] == quantiles[QUANTILES - 1] && forecast.noEchoProbability() >= 1) {
      return 0;
    }
    double sum = 0;
    for (int i = 0; i < FLOOR_POINTS; i++) {
      sum += loss(quantiles, forecast.quantileM((i + 0.5) / FLOOR_POINTS, noEchoM));
    }
    return sum / FLOOR_POINTS;
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
