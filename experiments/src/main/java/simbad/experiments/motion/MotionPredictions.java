package simbad.experiments.motion;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import simbad.motion.MotionRun;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.forecast.PinballLoss;
import simbad.sonar.format.CsvCell;

/** Forecasts of motion as the text of a csv file: 19 quantiles of each component, by window. */
public final class MotionPredictions {
  private static final String[] COMPONENTS = {"along_m", "across_m", "turn_deg"};

  /** Micrometres and millionths of a degree. */
  private static final int DECIMALS = 6;

  private MotionPredictions() {}

  /**
   * Forecasts the windows of some runs. A forecast sees commands up to the window's end and never
   * the track after its start.
   *
   * @param forecast the model
   * @param runs with commands, and a track that says which windows there are
   * @return a header and one line for each window, by run, start and horizon
   */
  public static String text(MotionForecast forecast, List<MotionRun> runs) {
    StringJoiner header = new StringJoiner(",").add("run").add("t_s").add("horizon_s");
    for (String component : COMPONENTS) {
      for (int q = 0; q < PinballLoss.QUANTILES; q++) {
        header.add(String.format(Locale.ROOT, "%s_q%02.0f", component, 100 * PinballLoss.level(q)));
      }
    }
    StringBuilder text = new StringBuilder(header + "\n");
    for (MotionForecast.Row row : forecast.of(runs)) {
      text.append(line(row)).append('\n');
    }
    return text.toString();
  }

  private static String line(MotionForecast.Row row) {
    StringJoiner line = new StringJoiner(",").add(CsvCell.of(row.run()));
    line.add(plain(row.startS())).add(plain(row.horizonS()));
    for (int c = 0; c < COMPONENTS.length; c++) {
      for (double value : row.quantiles()[c]) {
        line.add(plain(c == 2 ? Math.toDegrees(value) : value));
      }
    }
    return line.toString();
  }

  private static String plain(double value) {
    BigDecimal rounded = new BigDecimal(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }
}
