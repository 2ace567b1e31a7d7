package simbad.gap.calibrate.level;

import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;

/** Normal equations of least squares for some values, to which rows and precisions are added. */
final class Normal {
  private final RealMatrix left;
  private final double[] right;

  /**
   * Begins with what is known before any row: that each value is 0.
   *
   * @param precision how surely, copied
   */
  Normal(double[][] precision) {
    left = MatrixUtils.createRealMatrix(precision);
    right = new double[precision.length];
  }

  /** Adds a row: how much each value counts, how surely, and what was read. */
  void add(double[] row, double weight, double read) {
    for (int i = 0; i < row.length; i++) {
      right[i] += weight * row[i] * read;
      for (int j = 0; j < row.length; j++) {
        left.addToEntry(i, j, weight * row[i] * row[j]);
      }
    }
  }

  /**
   * Takes away what other values explain (a Schur complement).
   *
   * @param coupling of the others with these, a row for each of the others
   * @param solved the others' inverse times the coupling
   * @param others their own solution if these are 0
   */
  void leave(RealMatrix coupling, RealMatrix solved, double[] others) {
    RealMatrix taken = coupling.transposeMultiply(solved);
    double[] read = coupling.preMultiply(others);
    for (int i = 0; i < right.length; i++) {
      right[i] -= read[i];
      for (int j = 0; j < right.length; j++) {
        left.addToEntry(i, j, -taken.getEntry(i, j));
      }
    }
  }

  /** Returns the values. */
  double[] solve() {
    return Matrices.positive(left).getSolver().solve(new ArrayRealVector(right)).toArray();
  }

  /** Returns how surely the values are known: their covariance. */
  RealMatrix covariance() {
    return Matrices.positive(left).getSolver().getInverse();
  }
}
