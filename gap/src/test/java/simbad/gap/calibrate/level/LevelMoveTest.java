package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hipparchus.linear.MatrixUtils;
import org.junit.jupiter.api.Test;

/** Moves of a set-up of two values beside normal sums worked by hand. */
class LevelMoveTest {
  private static final double[] ONE = {1};

  /** Each reading is likeliest at its own shift, with a deviation of 1 dB. */
  private static EchoCurves normal(double... shifts) {
    return new EchoCurves(
        decibels -> {
          double[] values = new double[shifts.length];
          for (int i = 0; i < shifts.length; i++) {
            values[i] = -(decibels - shifts[i]) * (decibels - shifts[i]) / 2;
          }
          return values;
        });
  }

  private static LevelMove move(double[] precision, EchoCurves curves, int... valueOfRow) {
    List<LevelMove.Row> rows =
        java.util.stream.IntStream.range(0, valueOfRow.length)
            .mapToObj(i -> new LevelMove.Row(i, new int[] {valueOfRow[i]}, ONE))
            .toList();
    return new LevelMove(MatrixUtils.createRealDiagonalMatrix(precision), rows, curves);
  }

  /** n readings at 3 dB, a value known to 1 dB: it moves to 3 n / (n + 1), half of 9 n² / (n+1). */
  @Test
  void readingsPullAValueAsItsPriorLetsThem() {
    LevelMove move = move(new double[] {1, 1}, normal(3, 3, 3, 3), 0, 0, 0, 0);
    double nats = move.climb();

    assertEquals(9.0 * 16 / 5 / 2, nats, 0.2);
    assertEquals(12.0 / 5, move.shiftsDb()[0], 0.15);
  }

  /** What is known well stays; each place moves for itself. */
  @Test
  void onlyWhatIsOpenMoves() {
    LevelMove move = move(new double[] {1e6, 1e-3}, normal(3, 3), 0, 1);
    double nats = move.climb();

    assertEquals(4.5, nats, 0.1);
    assertEquals(0, move.shiftsDb()[0], 1e-3);
    assertEquals(3, move.shiftsDb()[1], 0.1);
  }

  /** A cliff between the start and the top: steps are halved, and nothing is lost by moving. */
  @Test
  void aMoveIsNeverALoss() {
    EchoCurves cliff =
        new EchoCurves(decibels -> new double[] {decibels < 2 ? -5 : decibels < 4 ? 0 : -9});

    assertTrue(move(new double[] {0.01, 1}, cliff, 0).climb() >= 0);
  }

  /** Before it moves, n readings tell n beside the 1 of the prior: the root of 1 / (n + 1). */
  @Test
  void whatReadingsTellIsTakenFromWhatWasOpen() {
    assertEquals(
        -Math.log(5) / 2,
        move(new double[] {1, 1}, normal(3, 3, 3, 3), 0, 0, 0, 0).logShare(),
        1e-9);
    assertEquals(
        -Math.log(2 * 1.5) / 2, move(new double[] {1, 2}, normal(3, 3), 0, 1).logShare(), 1e-9);
    assertEquals(0, move(new double[] {1, 1}, normal(3)).logShare(), 1e-12);
  }

  /** Where a curve bends upwards it tells nothing of how surely a value is known. */
  @Test
  void whatBendsUpwardsTellsNothing() {
    EchoCurves up = new EchoCurves(decibels -> new double[] {decibels * decibels / 2});

    assertEquals(0, move(new double[] {1}, up, 0).logShare(), 1e-12);
  }

  /** Two values that pull together, one of them known twice as well; the first has no row. */
  @Test
  void valuesFollowTheirSlopes() {
    LevelMove move =
        new LevelMove(
            MatrixUtils.createRealDiagonalMatrix(new double[] {1, 1, 4}),
            List.of(new LevelMove.Row(0, new int[] {1, 2}, new double[] {1, -2})),
            normal(3));
    double nats = move.climb();

    // v = 1 + 4 / 4; along (1, -2 / 4) by 3 / (1 + v).
    assertEquals(9.0 * 2 / 3 / 2, nats, 0.05);
    double[] values = move.valuesFrom(1);
    assertEquals(2, values.length);
    assertEquals(-0.5, values[1] / values[0], 1e-9);
    assertEquals(move.shiftsDb()[0], values[0] - 2 * values[1], 1e-12);
    assertEquals(0, move.valuesFrom(0)[0], 0);
  }
}
