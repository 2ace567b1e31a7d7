package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.junit.jupiter.api.Test;

/** Sums of rows and scores, and the values that they lead to, for systems solved by hand. */
class NormalEquationsTest {
  private static final double EXACT = 1e-9;

  private static RealMatrix matrix(double[]... rows) {
    return MatrixUtils.createRealMatrix(rows);
  }

  /** Left [[2 + 4, 8], [8, 3 + 16]] with determinant 50, right (20, 40). */
  @Test
  void aRowBesideAPriorSettlesBothValues() {
    double[][] precision = {{2, 0}, {0, 3}};
    Normal normal = new Normal(precision);
    normal.add(new double[] {1, 2}, 4, 5);

    assertArrayEquals(new double[] {1.2, 1.6}, normal.solve(), EXACT);
    RealMatrix known = normal.covariance();
    assertArrayEquals(new double[] {19 / 50.0, -8 / 50.0}, known.getRow(0), EXACT);
    assertArrayEquals(new double[] {-8 / 50.0, 6 / 50.0}, known.getRow(1), EXACT);
    assertEquals(2, precision[0][0], 0);
  }

  @Test
  void withoutARowEachValueIsNothing() {
    assertArrayEquals(new double[2], new Normal(new double[][] {{2, 0}, {0, 3}}).solve(), 0);
  }

  /**
   * [[4, 1, 1], [1, 3, 2], [1, 2, 5]] times (1, 2, 3) is (9, 13, 20). Without the third value the
   * first two are the same.
   */
  @Test
  void whatOthersExplainLeavesTheRestAsTogether() {
    Normal normal = new Normal(new double[][] {{3, 1}, {1, 2}});
    normal.add(new double[] {1, 0}, 1, 9);
    normal.add(new double[] {0, 1}, 1, 13);
    normal.leave(
        matrix(new double[] {1, 2}), matrix(new double[] {1 / 5.0, 2 / 5.0}), new double[] {4});

    assertArrayEquals(new double[] {1, 2}, normal.solve(), EXACT);
  }

  @Test
  void aDeterminantIsThatOfTheMatrix() {
    assertEquals(
        Math.log(36),
        Matrices.logDeterminant(matrix(new double[] {4, 0}, new double[] {0, 9})),
        EXACT);
    assertEquals(
        Math.log(3),
        Matrices.logDeterminant(matrix(new double[] {2, 1}, new double[] {1, 2})),
        EXACT);
  }

  /** The mean of [[2, 2], [0, 2]] and its mirror image is [[2, 1], [1, 2]]. */
  @Test
  void whatIsNotSymmetricIsMadeSo() {
    assertEquals(
        Math.log(3),
        Matrices.logDeterminant(matrix(new double[] {2, 2}, new double[] {0, 2})),
        EXACT);
  }

  /** What is positive already stays as it is: the root of 4 is 2. */
  @Test
  void aPositiveMatrixIsNotChanged() {
    assertEquals(2, Matrices.positive(matrix(new double[] {4})).getL().getEntry(0, 0), 0);
  }

  /** Below 0 by rounding: so little is added that hardly anything is there afterwards. */
  @Test
  void whatIsNotPositiveByRoundingOnlyIsMadeSo() {
    double[] row = {1, 0};
    double root = Matrices.positive(matrix(row, new double[] {0, -1e-6})).getL().getEntry(1, 1);

    assertTrue(root > 0 && root * root < 2e-5, () -> "root " + root);
  }

  @Test
  void whatIsFarFromPositiveIsRefused() {
    RealMatrix negative = matrix(new double[] {-1});

    assertThrows(IllegalStateException.class, () -> Matrices.positive(negative));
  }

  /** 3 times 11 less 5. */
  @Test
  void aPullIsTheSumOfItsProducts() {
    double[] values = {5, 7, 11};
    Pull pull = new Pull(new int[] {2, 0}, new double[] {3, -1});

    assertEquals(28, pull.dot(values), EXACT);
    assertEquals(28 + 4 * 7, pull.and(1, 4).dot(values), EXACT);
    assertEquals(2, pull.index().length);
  }

  /**
   * A score of 3 times 2, half of it: 3, with information 9 times 4, half of it: 18. A line of 2 by
   * which 5 is off: 10, with 4. Both values are known to 1 before.
   */
  @Test
  void scoresAndLinesMoveWhatTheyPull() {
    ScoreSums sums = new ScoreSums(2);
    sums.add(new Pull(new int[] {0}, new double[] {2}), 3, 0.5);
    sums.addLine(new Pull(new int[] {1}, new double[] {1}), 2, 5);
    RealMatrix precision = MatrixUtils.createRealIdentityMatrix(2);

    assertArrayEquals(new double[] {3 / 19.0, 10 / 5.0}, sums.move(precision), EXACT);
    assertEquals((3 * 3 / 19.0 + 10 * 2) / 2, sums.nats(precision), EXACT);
  }

  /** [[1 + 1, 2], [2, 1 + 4]] with determinant 6 takes (1, 2) to (1/6, 1/3). */
  @Test
  void whatIsPulledTogetherIsKnownTogether() {
    ScoreSums sums = new ScoreSums(2);
    sums.add(new Pull(new int[] {0, 1}, new double[] {1, 2}), 1, 1);
    RealMatrix precision = MatrixUtils.createRealIdentityMatrix(2);

    assertArrayEquals(new double[] {1 / 6.0, 1 / 3.0}, sums.move(precision), EXACT);
    assertEquals(5 / 12.0, sums.nats(precision), EXACT);
  }
}
