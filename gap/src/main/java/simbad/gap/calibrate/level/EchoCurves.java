package simbad.gap.calibrate.level;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * How likely each reading of a log is where the excess of what it hears is another: natural
 * logarithms at some shifts, cubic between them, straight beyond. Immutable.
 */
public final class EchoCurves {
  /** Dense where an edge is; an echo some 14 dB off is as good as none. */
  private static final double[] AT_DB = {
    -14, -9, -6, -4.5, -3.25, -2.25, -1.5, -0.75, 0, 0.75, 1.5, 2.25, 3.25, 4.5, 6, 9, 14
  };

  private static final double FLAT = 1e-9;

  private final double[][] value = new double[AT_DB.length][];

  /**
   * Asks how likely a log is.
   *
   * @param logLikelihood of each reading where all excesses are more by some decibels; is asked by
   *     several threads
   */
  public EchoCurves(DoubleFunction<double[]> logLikelihood) {
    IntStream.range(0, AT_DB.length)
        .parallel()
        .forEach(i -> value[i] = logLikelihood.apply(AT_DB[i]));
  }

  int size() {
    return value[0].length;
  }

  /** Whether the level of what it hears says nothing of a reading. */
  boolean isFlat(int ping) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (double[] own : value) {
      least = Math.min(least, own[ping]);
      most = Math.max(most, own[ping]);
    }
    return most - least < FLAT;
  }

  private static int cell(double decibels) {
    int cell = 0;
    while (cell < AT_DB.length - 2 && decibels >= AT_DB[cell + 1]) {
      cell++;
    }
    return cell;
  }

  /** The slope at a knot: of the parabola through it and its neighbours. */
  private double slope(int ping, int at) {
    if (at == 0 || at == AT_DB.length - 1) {
      return 0;
    }
    double before = AT_DB[at] - AT_DB[at - 1];
    double behind = AT_DB[at + 1] - AT_DB[at];
    double rise = (value[at][ping] - value[at - 1][ping]) / before;
    double next = (value[at + 1][ping] - value[at][ping]) / behind;
    double parabola = (rise * behind + next * before) / (before + behind);
    // Beside a cliff no curve may swing (Fritsch and Carlson 1980).
    double most = Math.min(Math.abs(rise), Math.abs(next)) * (rise * next > 0 ? 3 : 1);
    return Math.max(-most, Math.min(most, parabola));
  }

  /**
   * Finds how likely a reading is.
   *
   * @param ping index
   * @param decibels more
   * @param into its logarithm, the first and the second derivative
   */
  void at(int ping, double decibels, double[] into) {
    double inside = Math.max(AT_DB[0], Math.min(AT_DB[AT_DB.length - 1], decibels));
    int cell = cell(inside);
    double width = AT_DB[cell + 1] - AT_DB[cell];
    double t = (inside - AT_DB[cell]) / width;
    double from = value[cell][ping];
    double rise = value[cell + 1][ping] - from;
    double first = slope(ping, cell) * width;
    double last = slope(ping, cell + 1) * width;
    double square = 3 * rise - 2 * first - last;
    double cube = first + last - 2 * rise;
    into[0] = from + t * (first + t * (square + t * cube));
    boolean beyond = inside != decibels;
    into[1] = beyond ? 0 : (first + t * (2 * square + 3 * t * cube)) / width;
    into[2] = beyond ? 0 : (2 * square + 6 * t * cube) / (width * width);
  }
}
