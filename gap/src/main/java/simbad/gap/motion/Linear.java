package simbad.gap.motion;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;

/**
 * White residuals as a weighted linear regression on white columns, with the normal equations of
 * each block of the log, so that blocks can be left out at no cost.
 */
final class Linear {
  /** A log is compared with itself in so many parts, */
  private static final int PARTS = 10;

  /** of so many blocks each, */
  private static final int LEAST_IN_PART = 2;

  /** unless these are so few that they say nothing. */
  private static final int LEAST_PARTS = 4;

  /** Steps, of a fifth of a second each, over which scatter may hang together. */
  private static final int LASTING = 10;

  private final MotionSteps given;
  private final Whitening[] white;

  /** By value, component and step: by how much the white residual falls per unit. */
  private final double[][][] columns;

  private final double[][][] matrices;
  private final double[][] vectors;

  private final Belief belief;

  Linear(MotionSteps given, Whitening[] white, double[][][] columns) {
    this(given, white, columns, Belief.none(columns.length));
  }

  /**
   * Gathers the equations.
   *
   * @param given the steps
   * @param white residuals
   * @param columns by how much these fall per unit of each value
   * @param belief about the values before any block is seen
   */
  Linear(MotionSteps given, Whitening[] white, double[][][] columns, Belief belief) {
    this.given = given;
    this.belief = belief;
    this.white = white;
    this.columns = columns;
    matrices = new double[given.blockCount()][columns.length][columns.length];
    vectors = new double[given.blockCount()][columns.length];
    for (int c = 0; c < white.length; c++) {
      gather(c);
    }
  }

  /**
   * What is believed of values before any block is seen: blocks that say nothing of a value would
   * send it anywhere.
   *
   * @param precisions by value, one over the square of a standard deviation; 0 where nothing is
   * @param moves by value, from where it is to where it is believed
   */
  @SuppressWarnings("ArrayRecordComponent") // Numbers by value, never compared.
  record Belief(double[] precisions, double[] moves) {
    static Belief none(int values) {
      return new Belief(new double[values], new double[values]);
    }
  }

  private void gather(int c) {
    double information = white[c].information();
    for (int i = 0; i < given.size(); i++) {
      int block = given.block(i);
      double weight = white[c].weights[i];
      for (int p = 0; p < columns.length; p++) {
        double weighted = weight * columns[p][c][i];
        vectors[block][p] += weighted * white[c].white[i];
        for (int q = 0; q <= p; q++) {
          matrices[block][p][q] += information * weighted * columns[q][c][i];
        }
      }
    }
  }

  /** Returns by how much the values move for the least squares of some blocks. */
  double[] move(IntPredicate taken, double damping) {
    return move(taken, damping, Belief.none(columns.length));
  }

  private double[] move(IntPredicate taken, double damping, Belief prior) {
    if (columns.length == 0) {
      return new double[0];
    }
    double[][] matrix = matrix(taken);
    for (int p = 0; p < matrix.length; p++) {
      matrix[p][p] += damping * matrix[p][p] + prior.precisions[p] + 1e-12;
    }
    double[] vector = new double[matrix.length];
    Arrays.setAll(vector, p -> prior.precisions[p] * prior.moves[p]);
    IntStream.range(0, vectors.length)
        .filter(taken)
        .forEach(b -> IntStream.range(0, vector.length).forEach(p -> vector[p] += vectors[b][p]));
    return NormalMatrix.of(matrix).solve(vector);
  }

  private double[][] matrix(IntPredicate taken) {
    double[][] matrix = new double[columns.length][columns.length];
    for (int b = 0; b < matrices.length; b++) {
      for (int p = 0; taken.test(b) && p < matrix.length; p++) {
        for (int q = 0; q <= p; q++) {
          matrix[p][q] += matrices[b][p][q];
          matrix[q][p] = matrix[p][q];
        }
      }
    }
    return matrix;
  }

  /** Returns the same of all blocks but those of a fold, and of what is believed. */
  double[] withoutFold(int fold) {
    return move(block -> given.foldOf(block) != fold, 0, belief);
  }

  /** Returns the log density of each block, foretold by values that its fold had no part in. */
  double[] heldOut() {
    double[] scores = new double[given.blockCount()];
    double[][] moves = new double[MotionSteps.FOLDS][];
    for (int fold = 0; fold < moves.length; fold++) {
      int left = fold;
      moves[fold] = withoutFold(left);
    }
    for (int c = 0; c < white.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        int block = given.block(i);
        double[] move = moves[given.foldOf(block)];
        double z = white[c].white[i];
        for (int p = 0; p < move.length; p++) {
          z -= columns[p][c][i] * move[p];
        }
        scores[block] += white[c].logDensity(i, z);
      }
    }
    return scores;
  }

  /**
   * Returns standard errors of the values, from how far blocks pull apart (White 1982) and parts of
   * the log beyond that.
   */
  double[] standardErrors() {
    double[] errors = new double[columns.length];
    if (columns.length == 0) {
      return errors;
    }
    RealMatrix inverse = inverse();
    RealMatrix between = inverse.multiply(pulls()).multiply(inverse);
    double few = (double) given.blockCount() / Math.max(1, given.blockCount() - columns.length);
    for (int p = 0; p < errors.length; p++) {
      double own = Math.max(inverse.getEntry(p, p), few * between.getEntry(p, p));
      errors[p] = Math.sqrt(Math.max(0, wandering() * own));
    }
    return errors;
  }

  private RealMatrix inverse() {
    double[][] matrix = matrix(block -> true);
    for (int p = 0; p < matrix.length; p++) {
      matrix[p][p] += 1e-12;
    }
    return NormalMatrix.of(matrix).inverse();
  }

  /** The sum over all blocks of the squares of their pulls. */
  private RealMatrix pulls() {
    return squares(vectors);
  }

  private static RealMatrix squares(double[][] rows) {
    RealMatrix pulls = new Array2DRowRealMatrix(rows);
    return pulls.transpose().multiply(pulls);
  }

  /**
   * Returns by how many times blocks pull apart more than by chance, the mean over the values
   * (Rotnitzky and Jewell 1990; Pauli, Racugno and Ventura 2011); 1 without values. What
   * likelihoods gain is divided by it.
   */
  double clumping() {
    return columns.length == 0
        ? 1
        : Math.max(1, inverse().multiply(pulls()).getTrace() / columns.length) * wandering();
  }

  /**
   * Returns by how many times what lasts some steps and no longer makes sums of residuals scatter
   * more than by chance, the most of all components (Newey and West 1987, a flat window). What
   * lasts longer is no scatter, and is taken away: it has a cause.
   */
  double lasting() {
    double[] move = move(block -> true, 0);
    double most = 1;
    for (int c = 0; c < white.length; c++) {
      most = Math.max(most, lasting(pulls(c, move)));
    }
    return most;
  }

  /** How each residual of a component pulls, the values moved; far ones pull little. */
  private double[] pulls(int c, double[] move) {
    double[] pulls = new double[given.size()];
    for (int i = 0; i < pulls.length; i++) {
      double z = white[c].white[i];
      for (int p = 0; p < move.length; p++) {
        z -= columns[p][c][i] * move[p];
      }
      pulls[i] = white[c].weights[i] * z;
    }
    return pulls;
  }

  private double lasting(double[] pulls) {
    double[] products = new double[2 * LASTING + 1];
    int begin = 0;
    for (int i = 0; i < pulls.length; i++) {
      begin = given.isChained(i) ? begin : i;
      for (int lag = 0; lag < products.length && i - lag >= begin; lag++) {
        products[lag] += pulls[i] * pulls[i - lag];
      }
    }
    double sum = 1;
    for (int lag = 1; lag <= LASTING && products[0] > 0; lag++) {
      sum += 2 * (products[lag] - products[lag + LASTING]) / products[0];
    }
    return sum;
  }

  /**
   * Returns by how many times the pulls of whole parts of the log are larger than those of its
   * blocks foretell, the mean over the values: what the robot does wanders for minutes. At least 1,
   * and 1 where the log has too few blocks to say.
   */
  private double wandering() {
    Drift drift = drift(0);
    return drift.freedoms == 0 ? 1 : Math.max(1, drift.square / drift.freedoms);
  }

  /**
   * How far the values of whole parts of the log pull apart.
   *
   * @param square of their pulls, by what their blocks foretell: chi-square by chance
   * @param freedoms of the chi-square; 0 where the log has too few blocks to say
   */
  record Drift(double square, int freedoms) {}

  /**
   * Compares parts of the log.
   *
   * @param from the first of the values that are compared
   */
  Drift drift(int from) {
    int n = vectors.length;
    int values = columns.length - from;
    int parts = parts();
    if (parts < LEAST_PARTS || n < 2 * values) {
      return new Drift(0, 0);
    }
    double[][] pulls = new double[n][];
    Arrays.setAll(pulls, b -> Arrays.copyOfRange(vectors[b], from, columns.length));
    double[][] sums = new double[parts][values];
    double[] mean = new double[values];
    int[] sizes = new int[parts];
    for (int b = 0; b < n; b++) {
      int part = part(b);
      sizes[part]++;
      for (int p = 0; p < values; p++) {
        sums[part][p] += pulls[b][p] / Math.sqrt(n);
        mean[p] += pulls[b][p] / Math.sqrt(n) / n;
      }
    }
    RealMatrix usual = NormalMatrix.of(squares(pulls).scalarMultiply(1.0 / n).getData()).inverse();
    double square = 0;
    for (int part = 0; part < parts; part++) {
      RealVector own =
          new ArrayRealVector(sums[part])
              .subtract(new ArrayRealVector(mean).mapMultiply(sizes[part]));
      square += own.dotProduct(usual.operate(own)) * n / sizes[part];
    }
    return new Drift(square, values * (parts - 1));
  }

  /** Returns into how many parts a log is cut that is compared with itself. */
  int parts() {
    return Math.min(PARTS, vectors.length / LEAST_IN_PART);
  }

  /** Returns the part of a block. */
  int part(int block) {
    return (int) ((long) block * parts() / vectors.length);
  }
}
