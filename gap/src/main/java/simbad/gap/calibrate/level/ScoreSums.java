package simbad.gap.calibrate.level;

import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;

/** ScoreSums of scores, and of their squares. */
final class ScoreSums {
  private final double[] score;
  private final double[][] information;

  ScoreSums(int size) {
    score = new double[size];
    information = new double[size][size];
  }

  /** A score, of which a share counts. */
  void add(Pull pull, double rise, double share) {
    sum(pull, rise * share, rise * rise * share);
  }

  /** A line of least squares: what is off, and by how much it rises. */
  void addLine(Pull pull, double rise, double off) {
    sum(pull, rise * off, rise * rise);
  }

  private void sum(Pull pull, double slope, double square) {
    for (int i = 0; i < pull.index().length; i++) {
      double[] row = information[pull.index()[i]];
      score[pull.index()[i]] += slope * pull.value()[i];
      for (int j = 0; j < pull.index().length; j++) {
        row[pull.index()[j]] += square * pull.value()[i] * pull.value()[j];
      }
    }
  }

  /** Half the gain of a step to the top. */
  double nats(RealMatrix precision) {
    return new ArrayRealVector(move(precision)).dotProduct(new ArrayRealVector(score)) / 2;
  }

  /** The step to the top. */
  double[] move(RealMatrix precision) {
    RealMatrix all = precision.add(MatrixUtils.createRealMatrix(information));
    return Matrices.positive(all).getSolver().solve(new ArrayRealVector(score)).toArray();
  }
}
