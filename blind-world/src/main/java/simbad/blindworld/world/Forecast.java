package simbad.blindworld.world;

import java.util.Arrays;
import simbad.blindworld.check.Checks;
import simbad.blindworld.file.Decimals;

/** The 19 quantiles q05..q95 of each row's reading, no-echo counted as the scene says. */
public final class Forecast {

  /** How many quantiles a row has. */
  public static final int LEVELS = 19;

  private final double[][] quantilesM;

  /** A forecast with 19 rising quantiles for each row. */
  public Forecast(double[][] quantilesM) {
    for (double[] row : quantilesM) {
      Checks.numbers("quantile", row);
    }
    this.quantilesM = quantilesM.clone();
  }

  /** The level of a quantile: 0.05 for the first, 0.95 for the last. */
  public static double level(int index) {
    return (index + 1) / (LEVELS + 1.0);
  }

  /**
   * By repeats of the whole recording, so that whatever has a memory runs forward by itself.
   *
   * @param listening the recording before a world
   * @param noEchoM what a no-echo counts as
   * @param repeats how often it is simulated
   * @param seed of the first repeat
   */
  public static Forecast of(Repeats listening, double noEchoM, int repeats, long seed) {
    Checks.positive("no echo", noEchoM);
    Chance seeds = new Chance(seed);
    double[][] byRepeat = new double[repeats][];
    for (int i = 0; i < repeats; i++) {
      byRepeat[i] = listening.read(seeds.nextLong());
    }
    int rows = byRepeat[0].length;
    double[][] quantiles = new double[rows][LEVELS];
    double[] column = new double[repeats];
    for (int row = 0; row < rows; row++) {
      for (int i = 0; i < repeats; i++) {
        double reading = byRepeat[i][row];
        column[i] = reading < Double.POSITIVE_INFINITY ? reading : noEchoM;
      }
      Arrays.sort(column);
      for (int q = 0; q < LEVELS; q++) {
        quantiles[row][q] = column[(int) Math.ceil(level(q) * repeats) - 1];
      }
    }
    return new Forecast(quantiles);
  }

  /** The quantiles of one row, in metres; a copy. */
  public double[] row(int row) {
    return quantilesM[row].clone();
  }

  /** How many rows there are. */
  public int size() {
    return quantilesM.length;
  }

  /** A row's part in the gap: twice the mean pinball loss over the levels, in centimetres. */
  public double lossCm(int row, double countedM) {
    double sum = 0;
    for (int q = 0; q < LEVELS; q++) {
      double over = countedM - quantilesM[row][q];
      sum += over >= 0 ? level(q) * over : (level(q) - 1) * over;
    }
    return 100 * 2 * sum / LEVELS;
  }

  /** The gap of readings from this forecast, in centimetres; infinite readings are no-echoes. */
  public double gapCm(double[] readingsM, double noEchoM) {
    double sum = 0;
    for (int row = 0; row < readingsM.length; row++) {
      sum += lossCm(row, readingsM[row] < Double.POSITIVE_INFINITY ? readingsM[row] : noEchoM);
    }
    return sum / readingsM.length;
  }

  /** The forecast as a predictions file. */
  public String csv() {
    StringBuilder text = new StringBuilder();
    for (int q = 0; q < LEVELS; q++) {
      text.append(q == 0 ? "" : ",").append("q%02d".formatted(5 * (q + 1)));
    }
    text.append('\n');
    for (double[] row : quantilesM) {
      for (int q = 0; q < LEVELS; q++) {
        Decimals.append(q == 0 ? text : text.append(','), row[q], 4);
      }
      text.append('\n');
    }
    return text.toString();
  }
}
