package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NormalMatrixTest {
  /** Metres beside something that is a million times smaller: 2 x + y = 4, x + 3 y = 7. */
  @Test
  void solve_ofUnequalSizes_isExact() {
    double[][] matrix = {{2e12, 1e6}, {1e6, 3}};
    double[] values = NormalMatrix.of(matrix).solve(new double[] {4e6, 7});
    assertArrayEquals(new double[] {1e-6, 2}, values, 1e-12);
    assertEquals(0.4, NormalMatrix.of(matrix).inverse().getEntry(1, 1), 1e-12);
  }

  /** Two values that say the same share what both say. */
  @Test
  void solve_ofTheSameTwice_isShared() {
    double[] values = NormalMatrix.of(new double[][] {{1, 1}, {1, 1}}).solve(new double[] {2, 2});
    assertArrayEquals(new double[] {1, 1}, values, 1e-9);
  }

  @Test
  void solve_ofWhatSaysNothing_isZero() {
    double[] values = NormalMatrix.of(new double[][] {{0, 0}, {0, 4}}).solve(new double[] {0, 8});
    assertArrayEquals(new double[] {0, 2}, values, 1e-12);
  }
}
