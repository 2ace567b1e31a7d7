package simbad.blindworld.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.MotionLog;
import simbad.blindworld.motion.Windows;

/** What a sealed drive shows in its windows, and what the nominal forecast of them costs. */
public final class MotionSealed {

  /** How far a prediction's time may be from its half second. */
  private static final double NEAR_S = 0.03;

  private final Windows windows;
  private final double[][] shown;
  private final double[] nominal;

  private MotionSealed(Windows windows, double[][] shown, double[] nominal) {
    this.windows = windows;
    this.shown = shown;
    this.nominal = nominal;
  }

  /** That of a truth's folder. */
  static MotionSealed read(Path folder, JsonObject truth) throws IOException, FormatException {
    MotionLog log = MotionLog.track(folder.resolve("sealed-track.csv"));
    Windows windows = Windows.of(log.outing());
    List<Double> units = truth.numbers("sealed_nominal");
    if (units.size() != MotionForecast.FIGURES) {
      throw new FormatException(
          "%s, sealed_nominal: %d numbers, expected %d"
              .formatted(truth.where(), units.size(), MotionForecast.FIGURES));
    }
    return new MotionSealed(
        windows,
        windows.displacements(log.track()),
        units.stream().mapToDouble(Double::doubleValue).toArray());
  }

  /**
   * The gap of a file of predictions, in units of the nominal one; nothing without the file or
   * where it has none of the windows. A window that it lacks counts as the nominal mean.
   */
  Optional<Double> gap(Path file) throws IOException, FormatException {
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    Csv csv = Csv.read(file);
    int[][] columns = columns(csv);
    Map<String, Integer> rows = rows(csv);
    double[] sums = new double[MotionForecast.FIGURES];
    int[] counts = new int[sums.length];
    int found = 0;
    for (int i = 0; i < windows.size(); i++) {
      Windows.Window window = windows.at(i);
      Integer row = rows.get(key(windows.run(i), window.beginS(), window.horizonS()));
      found += row == null ? 0 : 1;
      for (int c = 0; c < Windows.COMPONENTS; c++) {
        int figure = window.horizon() * Windows.COMPONENTS + c;
        counts[figure]++;
        sums[figure] +=
            row == null
                ? nominal[figure]
                : forecast(file, csv, row, columns[c]).loss(0, 0, shown[i][c]);
      }
    }
    for (int figure = 0; figure < sums.length; figure++) {
      sums[figure] /= Math.max(1, counts[figure]);
    }
    return found == 0 ? Optional.empty() : Optional.of(MotionForecast.gap(sums, nominal));
  }

  private static int[][] columns(Csv csv) throws FormatException {
    int[][] columns = new int[Windows.COMPONENTS][MotionForecast.LEVELS];
    for (int c = 0; c < columns.length; c++) {
      for (int q = 0; q < MotionForecast.LEVELS; q++) {
        columns[c][q] = csv.column(MotionForecast.column(MotionForecast.NAMES.get(c), q));
      }
    }
    return columns;
  }

  private static Map<String, Integer> rows(Csv csv) throws FormatException {
    int run = csv.column("run");
    int time = csv.column("t_s");
    int horizon = csv.column("horizon_s");
    Map<String, Integer> rows = new HashMap<>();
    for (int row = 0; row < csv.size(); row++) {
      double at = csv.number(row, time);
      if (Math.abs(at - Math.rint(2 * at) / 2) <= NEAR_S) {
        rows.put(key(csv.text(row, run), at, csv.number(row, horizon)), row);
      }
    }
    return rows;
  }

  private static String key(String run, double atS, double horizonS) {
    return Math.round(2 * atS) + "/" + Math.round(2 * horizonS) + "/" + run;
  }

  private static MotionForecast forecast(Path file, Csv csv, int row, int[] columns)
      throws FormatException {
    double[] quantiles = new double[columns.length];
    for (int q = 0; q < columns.length; q++) {
      quantiles[q] = csv.number(row, columns[q]);
      if (q > 0 && quantiles[q] < quantiles[q - 1]) {
        throw new FormatException(
            "%s, line %d: quantiles that fall, expected rising ones".formatted(file, row + 2));
      }
    }
    return new MotionForecast(new double[][][] {{quantiles}});
  }
}
