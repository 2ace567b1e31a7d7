package simbad.gap.motion;

import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.DecompositionSolver;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.SingularValueDecomposition;

/**
 * The matrix of normal equations, symmetric and not negative. Values of different units are brought
 * to one size first. Where some of them say the same, the solution is the shortest one.
 */
final class NormalMatrix {
  /** A column that others make up but for this share says nothing of its own. */
  private static final double DEPENDENT = 1e-10;

  private static final double SYMMETRY = 1e-9;

  private final double[] sizes;
  private final DecompositionSolver solver;

  private NormalMatrix(double[] sizes, DecompositionSolver solver) {
    this.sizes = sizes;
    this.solver = solver;
  }

  /** Prepares a matrix, which is not kept. */
  static NormalMatrix of(double[][] matrix) {
    int n = matrix.length;
    double[] sizes = new double[n];
    for (int p = 0; p < n; p++) {
      sizes[p] = matrix[p][p] > 0 ? Math.sqrt(matrix[p][p]) : 1;
    }
    double[][] scaled = new double[n][n];
    for (int p = 0; p < n; p++) {
      for (int q = 0; q < n; q++) {
        scaled[p][q] = matrix[p][q] / sizes[p] / sizes[q];
      }
    }
    return new NormalMatrix(sizes, solver(new Array2DRowRealMatrix(scaled, false)));
  }

  private static DecompositionSolver solver(RealMatrix scaled) {
    try {
      return new CholeskyDecomposition(scaled, SYMMETRY, DEPENDENT).getSolver();
    } catch (MathRuntimeException dependent) {
      return new SingularValueDecomposition(scaled).getSolver();
    }
  }

  /** Returns the values that make a vector. */
  double[] solve(double[] vector) {
    double[] scaled = new double[vector.length];
    for (int p = 0; p < scaled.length; p++) {
      scaled[p] = vector[p] / sizes[p];
    }
    double[] values = solver.solve(new ArrayRealVector(scaled, false)).toArray();
    for (int p = 0; p < values.length; p++) {
      values[p] /= sizes[p];
    }
    return values;
  }

  /** Returns the inverse. */
  RealMatrix inverse() {
    RealMatrix inverse = solver.getInverse();
    for (int p = 0; p < sizes.length; p++) {
      for (int q = 0; q < sizes.length; q++) {
        inverse.setEntry(p, q, inverse.getEntry(p, q) / sizes[p] / sizes[q]);
      }
    }
    return inverse;
  }
}
