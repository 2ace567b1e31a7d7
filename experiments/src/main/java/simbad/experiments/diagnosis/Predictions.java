package simbad.experiments.diagnosis;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.ForecastGap;
import simbad.motion.forecast.PinballLoss;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** Predictions as the text of a csv file: the quantiles q05 to q95 in metres. */
public final class Predictions {
  /** Micrometres, so that a rounded range does not show what is left of its computation. */
  private static final int DECIMALS = 6;

  private Predictions() {}

  /**
   * Predicts the readings at some poses.
   *
   * @param setup as the simulator believes it
   * @param changes what is different in the world; none for the simulator as it is
   * @param rows where readings are predicted, in any order
   * @return a header and one line for each row, in the rows' order
   */
  public static String text(
      SensingSetup setup, List<? extends Change> changes, List<ReadingRow> rows) {
    PingLog log = new PingLog(rows);
    ChangedModel model = new ChangedModel(setup, changes);
    List<ReadingDistribution> forecasts = model.forecast(model.geometry(log));
    String[] lines = new String[rows.size()];
    IntStream.range(0, lines.length)
        .parallel()
        .forEach(ping -> lines[log.row(ping)] = line(forecasts.get(ping), setup.noEchoM()));
    return header()
        + "\n"
        + List.of(lines).stream().map(l -> l + "\n").collect(Collectors.joining());
  }

  private static String header() {
    return IntStream.range(0, PinballLoss.QUANTILES)
        .mapToObj(i -> String.format(Locale.ROOT, "q%02.0f", 100 * PinballLoss.level(i)))
        .collect(Collectors.joining(","));
  }

  private static String line(ReadingDistribution forecast, double noEchoM) {
    return DoubleStream.of(ForecastGap.quantilesM(forecast, noEchoM))
        .mapToObj(Predictions::metres)
        .collect(Collectors.joining(","));
  }

  private static String metres(double value) {
    return new BigDecimal(value)
        .setScale(DECIMALS, RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }
}
