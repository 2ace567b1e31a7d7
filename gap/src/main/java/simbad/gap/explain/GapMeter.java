package simbad.gap.explain;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hipparchus.special.Gamma;
import simbad.gap.diagnosis.ForecastGap;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.DiagnosedModel;

/**
 * Measures the gap of each ping, as {@link ForecastGap} says. Predictions never look at readings.
 */
public final class GapMeter {
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
   * @param squareM2 expectation of its square, square metres
   */
  @SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
  public record Gaps(double[] observedM, double[] expectedM, double[] squareM2) {
    /** Gaps of no ping yet. */
    static Gaps empty(int pings) {
      return new Gaps(new double[pings], new double[pings], new double[pings]);
    }

    /** Takes one ping from others. */
    void take(Gaps other, int ping) {
      observedM[ping] = other.observedM[ping];
      expectedM[ping] = other.expectedM[ping];
      squareM2[ping] = other.squareM2[ping];
    }

    /**
     * Returns how probable it is that pings whose gap is some times what the model expects come to
     * as much as these by chance. A gap is made of few large ones where an echo is lost or comes
     * unexpected: one of them more is no proof. The sum is taken for one of a gamma distribution
     * with its mean and its variance, as sums of rare events nearly are.
     *
     * @param times what the model expects of itself
     * @param clumping by how much more sums vary than those of independent pings
     * @return 1 where nothing is expected and nothing seen, 0 where something is seen all the same
     */
    public double chance(double times, double clumping) {
      double mean = times * sum(expectedM);
      double seen = sum(observedM);
      double variance = 0;
      for (int i = 0; i < squareM2.length; i++) {
        variance += squareM2[i] - expectedM[i] * expectedM[i];
      }
      variance *= times * clumping;
      if (mean <= 0 || variance <= 0) {
        return seen <= mean ? 1 : 0;
      }
      return Gamma.regularizedGammaQ(mean * mean / variance, seen * mean / variance);
    }

    private static double sum(double[] values) {
      return Arrays.stream(values).sum();
    }
  }

  /** Measures a hypothesis. */
  public Gaps measure(Evidence evidence, Hypothesis hypothesis) {
    DiagnosedModel model = evidence.model(hypothesis);
    List<ReadingDistribution> forecast = model.forecast(evidence.geometry(model));
    Gaps gaps = Gaps.empty(log.size());
    IntStream.range(0, log.size())
        .parallel()
        .forEach(
            ping -> {
              double[] quantiles = ForecastGap.quantilesM(forecast.get(ping), noEchoM);
              double read = log.echo(ping) ? log.rangeM(ping) : noEchoM;
              gaps.observedM[ping] = ForecastGap.gapM(quantiles, read);
              expect(gaps, ping, forecast.get(ping), quantiles);
            });
    return gaps;
  }

  private void expect(Gaps gaps, int ping, ReadingDistribution forecast, double[] quantiles) {
    double silent = forecast.noEchoProbability();
    double gap = ForecastGap.gapM(quantiles, noEchoM);
    double sum = silent * gap;
    double squares = silent * gap * gap;
    double each = (1 - silent) / FLOOR_POINTS;
    // Echoes and misses apart: a rare one of either costs much and would fall between quantiles.
    if (each > LEAST) {
      double[] levels = new double[FLOOR_POINTS];
      Arrays.setAll(levels, i -> (i + 0.5) * each);
      for (double read : forecast.quantilesM(levels, BEYOND_M)) {
        gap = ForecastGap.gapM(quantiles, read);
        sum += each * gap;
        squares += each * gap * gap;
      }
    }
    gaps.expectedM[ping] = sum;
    gaps.squareM2[ping] = squares;
  }
}
