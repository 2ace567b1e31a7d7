package simbad.gap.motion;

import java.util.List;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.CholeskyDecomposition;
import simbad.motion.Command;
import simbad.motion.MotionRun;

/**
 * What a plain linear filter still foretells of what a model leaves over: of the commands of the
 * last second, time, heading and place. What it takes away has a cause that is not named.
 */
final class Residue {
  private static final int LAGS = 7;
  private static final double LAG_S = 0.2;
  private static final int FEATURES = 2 * LAGS + 9;

  /** A slip must not lead the filter: residuals are cut at so many scales. */
  private static final double CUT = 4;

  /** Share of its weight by which every feature is held at 0. */
  private static final double RIDGE = 1e-4;

  private final Evidence evidence;
  private final double[][] features;

  Residue(Evidence evidence) {
    this.evidence = evidence;
    features = new double[evidence.size()][];
    for (int i = 0; i < features.length; i++) {
      features[i] = features(evidence.window(i));
    }
  }

  /**
   * What is left of residuals on blocks that the filter was not fitted to.
   *
   * @param share of the absolute residuals that it takes away, by component; below 0 where it harms
   * @param z by how many standard errors, over all components together
   */
  @SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
  record Left(double[] share, double z) {}

  Left of(double[][] residuals, Scatter scatter) {
    double[][] left = new double[residuals.length][3];
    for (int c = 0; c < 3; c++) {
      for (int fold = 0; fold < Evidence.FOLDS; fold++) {
        double[] filter = filter(residuals, c, fold, CUT * scatter.scales()[c]);
        for (int i = 0; i < left.length; i++) {
          if (evidence.fold(i) == fold) {
            left[i][c] = residuals[i][c] - dot(filter, features[i]);
          }
        }
      }
    }
    return compare(residuals, left, scatter);
  }

  private Left compare(double[][] before, double[][] after, Scatter scatter) {
    double[] sumsBefore = new double[3];
    double[] sumsAfter = new double[3];
    double[] blockBefore = new double[evidence.blockCount()];
    double[] blockAfter = new double[evidence.blockCount()];
    for (int i = 0; i < before.length; i++) {
      for (int c = 0; c < 3; c++) {
        sumsBefore[c] += Math.abs(before[i][c]);
        sumsAfter[c] += Math.abs(after[i][c]);
        blockBefore[evidence.block(i)] -= Math.abs(before[i][c]) / scatter.scales()[c];
        blockAfter[evidence.block(i)] -= Math.abs(after[i][c]) / scatter.scales()[c];
      }
    }
    double[] share = new double[3];
    for (int c = 0; c < 3; c++) {
      share[c] = sumsBefore[c] > 0 ? 1 - sumsAfter[c] / sumsBefore[c] : 0;
    }
    return new Left(share, HeldOut.z(blockAfter, blockBefore));
  }

  private double[] filter(double[][] residuals, int component, int leftOut, double cut) {
    double[][] matrix = new double[FEATURES][FEATURES];
    double[] vector = new double[FEATURES];
    for (int w = 0; w < residuals.length; w++) {
      if (evidence.fold(w) != leftOut) {
        double value = Math.max(-cut, Math.min(cut, residuals[w][component]));
        for (int i = 0; i < FEATURES; i++) {
          vector[i] += features[w][i] * value;
          for (int j = 0; j < FEATURES; j++) {
            matrix[i][j] += features[w][i] * features[w][j];
          }
        }
      }
    }
    for (int i = 0; i < FEATURES; i++) {
      matrix[i][i] += RIDGE * matrix[i][i] + 1e-9;
    }
    return new CholeskyDecomposition(new Array2DRowRealMatrix(matrix), 1e-6, 1e-14)
        .getSolver()
        .solve(new ArrayRealVector(vector))
        .toArray();
  }

  private double[] features(Window window) {
    MotionRun run = evidence.runs().get(window.run());
    double[] x = new double[FEATURES];
    for (int lag = 0; lag < LAGS; lag++) {
      Command command = held(run.commands(), window.endS() - lag * LAG_S);
      x[lag] = command.speedMPerS();
      x[LAGS + lag] = command.turnRadPerS();
    }
    int i = 2 * LAGS;
    double speed = x[2];
    double minutes = (window.startS() - run.commands().get(0).timeS()) / 60;
    x[i++] = 1;
    x[i++] = minutes * speed;
    x[i++] = minutes * x[LAGS + 2];
    x[i++] = Math.cos(window.headingRad());
    x[i++] = Math.sin(window.headingRad());
    x[i++] = speed * Math.abs(speed);
    x[i++] = x[LAGS + 2] * Math.abs(x[LAGS + 2]);
    x[i++] = speed * x[LAGS + 2];
    x[i] = minutes;
    return x;
  }

  private static Command held(List<Command> commands, double timeS) {
    int low = 0;
    int high = commands.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (commands.get(middle).timeS() <= timeS) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return commands.get(low);
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }
}
