package simbad.gap.calibrate.level;

import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.RealMatrix;

/** What is done to matrices that are positive definite but for rounding. */
final class Matrices {
  private static final double SYMMETRY = 1e-9;
  private static final double LEAST = 1e-12;
  private static final int TRIES = 12;

  private Matrices() {}

  /** Returns the logarithm of the determinant of a positive matrix, natural. */
  static double logDeterminant(RealMatrix matrix) {
    RealMatrix lower = positive(matrix).getL();
    double sum = 0;
    for (int i = 0; i < lower.getRowDimension(); i++) {
      sum += 2 * Math.log(lower.getEntry(i, i));
    }
    return sum;
  }

  /** Decomposes a matrix; as much is added to its diagonal as that takes. */
  static CholeskyDecomposition positive(RealMatrix raw) {
    RealMatrix matrix = raw.add(raw.transpose()).scalarMultiply(0.5);
    double added = LEAST;
    for (int i = 0; i < TRIES; i++) {
      try {
        return new CholeskyDecomposition(matrix, SYMMETRY, LEAST);
      } catch (MathRuntimeException e) {
        for (int k = 0; k < matrix.getRowDimension(); k++) {
          matrix.addToEntry(k, k, added * (1 + Math.abs(matrix.getEntry(k, k))));
        }
        added *= 10;
      }
    }
    throw new IllegalStateException("no positive matrix");
  }
}
