package simbad.benchmarks.reach;

import java.util.List;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.SingularValueDecomposition;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/**
 * What a robot makes of a window as a constant and a weighted sum of what was commanded in it and
 * in the same window up to a second earlier, speed and turn: the yardstick of how much of motion
 * has a cause in the commands. It has no names, and says nothing of wheels.
 */
final class LinearFilter {
  private static final int LAGS = 11;
  private static final double LAG_S = 0.1;
  private static final int VALUES = 2 * LAGS + 1;
  private static final double RIDGE = 1e-6;
  private static final int ROUNDS = 30;

  /** Below it an error counts by its square, metres or radians. */
  private static final double LEAST = 1e-4;

  private final MotionRun run;
  private final int component;
  private final double[] weights;

  private LinearFilter(MotionRun run, int component, double[] weights) {
    this.run = run;
    this.component = component;
    this.weights = weights;
  }

  /**
   * Fits the weights that make absolute errors least, so that what is far out counts little.
   *
   * @param run with the commands
   * @param windows of that run
   * @param component 0 for along, 2 for the turn
   */
  static LinearFilter fitted(MotionRun run, List<Window> windows, int component) {
    double[][] rows = new double[windows.size()][];
    double[] seen = new double[rows.length];
    LinearFilter blank = new LinearFilter(run, component, new double[VALUES]);
    for (int i = 0; i < rows.length; i++) {
      rows[i] = blank.asked(windows.get(i));
      seen[i] = seen(windows.get(i), component);
    }
    double[] counts = new double[rows.length];
    double[] weights = new double[VALUES];
    for (int round = 0; round < ROUNDS; round++) {
      for (int i = 0; i < rows.length; i++) {
        double off = seen[i] - sum(weights, rows[i]);
        counts[i] = round == 0 ? 1 : 1 / Math.max(LEAST, Math.abs(off));
      }
      weights = leastSquares(rows, seen, counts);
    }
    return new LinearFilter(run, component, weights);
  }

  private static double[] leastSquares(double[][] rows, double[] seen, double[] counts) {
    double[][] matrix = new double[VALUES][VALUES];
    double[] vector = new double[VALUES];
    for (int i = 0; i < rows.length; i++) {
      for (int p = 0; p < VALUES; p++) {
        vector[p] += counts[i] * rows[i][p] * seen[i];
        for (int q = 0; q < VALUES; q++) {
          matrix[p][q] += counts[i] * rows[i][p] * rows[i][q];
        }
      }
    }
    for (int p = 0; p < VALUES; p++) {
      matrix[p][p] *= 1 + RIDGE;
    }
    return new SingularValueDecomposition(new Array2DRowRealMatrix(matrix))
        .getSolver()
        .solve(new ArrayRealVector(vector))
        .toArray();
  }

  static double seen(Window window, int component) {
    double way = window.way().component(component);
    return component == 2 ? Math.IEEEremainder(way, 2 * Math.PI) : way;
  }

  /** Returns by how much the filter is off. */
  double off(Window window) {
    return seen(window, component) - sum(weights, asked(window));
  }

  private static double sum(double[] weights, double[] row) {
    double sum = 0;
    for (int p = 0; p < row.length; p++) {
      sum += weights[p] * row[p];
    }
    return sum;
  }

  /** What was asked for within the window, and within it when it was so much earlier. */
  private double[] asked(Window window) {
    double[] asked = new double[VALUES];
    for (int p = 0; p < LAGS; p++) {
      double late = p * LAG_S;
      asked[p] = asked(window.startS() - late, window.endS() - late, false);
      asked[LAGS + p] = asked(window.startS() - late, window.endS() - late, true);
    }
    asked[2 * LAGS] = window.horizonS();
    return asked;
  }

  private double asked(double fromS, double toS, boolean turns) {
    List<Command> commands = run.commands();
    int at = Math.max(0, index(commands, fromS));
    double sum = 0;
    for (; at < commands.size() && commands.get(at).timeS() < toS; at++) {
      double begins = Math.max(fromS, commands.get(at).timeS());
      double ends = at + 1 < commands.size() ? Math.min(toS, commands.get(at + 1).timeS()) : toS;
      Command held = commands.get(at);
      double rate = turns ? held.turnRadPerS() : held.speedMPerS();
      sum += rate * Math.max(0, ends - begins);
    }
    return sum;
  }

  /** The last command that is not later. */
  private static int index(List<Command> commands, double timeS) {
    int low = -1;
    int high = commands.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (commands.get(middle).timeS() <= timeS) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
