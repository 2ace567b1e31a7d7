package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;

/**
 * Moves the values of a set-up's levels to where they and a log are most probable together, by
 * Newton's method; curvature that points upwards is left out.
 */
final class LevelMove {
  private static final int STEPS = 12;
  private static final int HALVINGS = 6;

  /** A step that gains less ends the search, natural. */
  private static final double GAIN = 0.1;

  private final RealMatrix precision;
  private final List<Row> rows;
  private final EchoCurves echoes;
  private final double start;
  private final double[] at = new double[3];
  private double[] values;

  /** Of each row at the values: the derivatives of its curve. */
  private Derivatives here;

  /** The same at values that are tried. */
  private Derivatives tried;

  /** A reading, and how its excess moves with some of the values. */
  @SuppressWarnings("ArrayRecordComponent") // read only
  record Row(int ping, int[] index, double[] value) {
    double shift(double[] values) {
      double sum = 0;
      for (int i = 0; i < index.length; i++) {
        sum += value[i] * values[index[i]];
      }
      return sum;
    }
  }

  LevelMove(RealMatrix precision, List<Row> rows, EchoCurves echoes) {
    this.precision = precision;
    this.rows = rows;
    this.echoes = echoes;
    values = new double[precision.getRowDimension()];
    here = new Derivatives(rows.size());
    tried = new Derivatives(rows.size());
    start = top(values);
    keepTried();
  }

  /** The first and the second, one for each row. */
  @SuppressWarnings("ArrayRecordComponent") // filled anew
  private record Derivatives(double[] first, double[] second) {
    Derivatives(int rows) {
      this(new double[rows], new double[rows]);
    }
  }

  private void keepTried() {
    Derivatives spare = here;
    here = tried;
    tried = spare;
  }

  /** Finds where; returns by how many nats log and set-up are likelier there. */
  double climb() {
    double height = start;
    for (int step = 0; step < STEPS; step++) {
      RealVector move = move();
      double next = height;
      for (int halving = 0; halving < HALVINGS && next <= height; halving++) {
        double[] there = new ArrayRealVector(values).add(move).toArray();
        double top = top(there);
        if (top > height) {
          values = there;
          keepTried();
          next = top;
        }
        move = move.mapMultiply(0.5);
      }
      double gain = next - height;
      height = next;
      if (gain < GAIN) {
        break;
      }
    }
    return height - start;
  }

  /**
   * Returns the logarithm of the share of what the values could be before that they still can be:
   * at most 0, by Laplace's approximation at where they are.
   */
  double logShare() {
    return (Matrices.logDeterminant(precision) - Matrices.logDeterminant(information())) / 2;
  }

  /** Returns the values from one on. */
  double[] valuesFrom(int first) {
    return Arrays.copyOfRange(values, first, values.length);
  }

  /** Returns by how many decibels each reading has moved. */
  double[] shiftsDb() {
    double[] shifts = new double[echoes.size()];
    rows.forEach(row -> shifts[row.ping] = row.shift(values));
    return shifts;
  }

  private double top(double[] there) {
    ArrayRealVector vector = new ArrayRealVector(there, false);
    double sum = -precision.operate(vector).dotProduct(vector) / 2;
    for (int i = 0; i < rows.size(); i++) {
      Row row = rows.get(i);
      echoes.at(row.ping, row.shift(there), at);
      sum += at[0];
      tried.first[i] = at[1];
      tried.second[i] = at[2];
    }
    return sum;
  }

  private RealVector move() {
    double[] score = precision.operate(new ArrayRealVector(values)).mapMultiply(-1).toArray();
    for (int k = 0; k < rows.size(); k++) {
      Row row = rows.get(k);
      for (int i = 0; i < row.index.length; i++) {
        score[row.index[i]] += here.first[k] * row.value[i];
      }
    }
    return Matrices.positive(information()).getSolver().solve(new ArrayRealVector(score));
  }

  /** How surely the values are known, by prior and log together. */
  private RealMatrix information() {
    double[][] information = precision.getData();
    for (int k = 0; k < rows.size(); k++) {
      Row row = rows.get(k);
      double down = Math.max(0, -here.second[k]);
      for (int i = 0; i < row.index.length; i++) {
        double[] into = information[row.index[i]];
        double own = down * row.value[i];
        for (int j = 0; j < row.index.length && own != 0; j++) {
          into[row.index[j]] += own * row.value[j];
        }
      }
    }
    return MatrixUtils.createRealMatrix(information);
  }
}
