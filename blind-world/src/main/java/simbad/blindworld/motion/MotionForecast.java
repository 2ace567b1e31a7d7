package simbad.blindworld.motion;

import java.util.Arrays;
import java.util.List;
import simbad.blindworld.check.Checks;
import simbad.blindworld.file.Decimals;
import simbad.blindworld.world.Chance;

/** The 19 quantiles q05..q95 of what each window will show: along, across and turn. */
public final class MotionForecast {

  /** How many quantiles each component has. */
  public static final int LEVELS = 19;

  /** Means by horizon and component. */
  public static final int FIGURES = Windows.HORIZONS_S.length * Windows.COMPONENTS;

  /** The components as files spell them. */
  public static final List<String> NAMES = List.of("along_m", "across_m", "turn_deg");

  private static final int[] DECIMALS = {5, 5, 4};

  private final double[][][] quantiles;

  /** By window and component, rising. */
  public MotionForecast(double[][][] quantiles) {
    for (double[][] window : quantiles) {
      for (double[] component : window) {
        Checks.numbers("quantile", component);
      }
    }
    this.quantiles = quantiles.clone();
  }

  /** The level of a quantile: 0.05 for the first, 0.95 for the last. */
  static double level(int index) {
    return (index + 1) / (LEVELS + 1.0);
  }

  /**
   * By repeats of the whole outing, so that whatever has a memory runs forward by itself and no
   * track is looked at.
   *
   * @param world that drives
   * @param outing of which only the frames at half seconds count
   * @param repeats how often it is driven
   * @param seed of the first repeat
   */
  public static MotionForecast of(MotionWorld world, Outing outing, int repeats, long seed) {
    Outing thin = outing.atBeats();
    Windows windows = Windows.of(thin);
    Chance seeds = new Chance(seed);
    double[][][] shown = new double[repeats][][];
    for (int i = 0; i < repeats; i++) {
      shown[i] = windows.displacements(world.drive(thin, seeds.nextLong()));
    }
    double[][][] quantiles = new double[windows.size()][Windows.COMPONENTS][LEVELS];
    double[] column = new double[repeats];
    for (int window = 0; window < quantiles.length; window++) {
      for (int c = 0; c < Windows.COMPONENTS; c++) {
        for (int i = 0; i < repeats; i++) {
          column[i] = shown[i][window][c];
        }
        Arrays.sort(column);
        for (int q = 0; q < LEVELS; q++) {
          quantiles[window][c][q] = between(column, level(q) * repeats - 0.5);
        }
      }
    }
    return new MotionForecast(quantiles);
  }

  /** Between the two sorted values beside a place. */
  private static double between(double[] sorted, double place) {
    int low = (int) Math.max(0, Math.min(sorted.length - 1.0, Math.floor(place)));
    int high = Math.min(sorted.length - 1, low + 1);
    double share = Math.max(0, Math.min(1, place - low));
    return sorted[low] + share * (sorted[high] - sorted[low]);
  }

  /** How many windows it is of. */
  public int size() {
    return quantiles.length;
  }

  /** The quantiles of a window's component; a copy. */
  public double[] of(int window, int component) {
    return quantiles[window][component].clone();
  }

  /** Twice the mean pinball loss over the levels, in the component's unit. */
  public double loss(int window, int component, double shown) {
    double[] row = quantiles[window][component];
    double sum = 0;
    for (int q = 0; q < LEVELS; q++) {
      double over = shown - row[q];
      sum += over >= 0 ? level(q) * over : (level(q) - 1) * over;
    }
    return 2 * sum / LEVELS;
  }

  /**
   * The mean losses by horizon and component, horizons first; 0 for a horizon without a window.
   *
   * @param windows that it is of
   * @param shown by window and component
   */
  public double[] losses(Windows windows, double[][] shown) {
    double[] sums = new double[FIGURES];
    int[] counts = new int[FIGURES];
    for (int window = 0; window < windows.size(); window++) {
      for (int c = 0; c < Windows.COMPONENTS; c++) {
        int figure = windows.at(window).horizon() * Windows.COMPONENTS + c;
        sums[figure] += loss(window, c, shown[window][c]);
        counts[figure]++;
      }
    }
    for (int figure = 0; figure < FIGURES; figure++) {
      sums[figure] /= Math.max(1, counts[figure]);
    }
    return sums;
  }

  /** The gap: the mean of the losses, each in units of its nominal value. */
  public static double gap(double[] losses, double[] nominal) {
    double sum = 0;
    int counted = 0;
    for (int figure = 0; figure < losses.length; figure++) {
      if (nominal[figure] > 0) {
        sum += losses[figure] / nominal[figure];
        counted++;
      }
    }
    return counted == 0 ? 0 : sum / counted;
  }

  /** The header of a file of predictions. */
  public static String header() {
    StringBuilder text = new StringBuilder("run,t_s,horizon_s");
    for (String name : NAMES) {
      for (int q = 0; q < LEVELS; q++) {
        text.append(',').append(column(name, q));
      }
    }
    return text.append('\n').toString();
  }

  /** The name of a quantile's column. */
  public static String column(String component, int quantile) {
    return component + "_q%02d".formatted(5 * (quantile + 1));
  }

  /** The forecast as a file of predictions. */
  public String csv(Windows windows) {
    StringBuilder text = new StringBuilder(header());
    for (int window = 0; window < size(); window++) {
      text.append(windows.run(window)).append(',');
      Decimals.append(text, windows.at(window).beginS(), 3).append(',');
      Decimals.append(text, windows.at(window).horizonS(), 1);
      for (int c = 0; c < Windows.COMPONENTS; c++) {
        for (double value : quantiles[window][c]) {
          Decimals.append(text.append(','), value, DECIMALS[c]);
        }
      }
      text.append('\n');
    }
    return text.toString();
  }
}
