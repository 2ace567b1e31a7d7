package simbad.gap.unexplained;

import java.util.Arrays;
import simbad.gap.score.Blocks;

/**
 * By how much more sums over blocks of time vary than those of independent readings would: readings
 * that are near in time are often off together.
 */
public final class Clumping {
  /** Blocks in which less could happen say nothing. */
  private static final double LEAST_VARIANCE = 0.5;

  private static final double LEAST_SQUARES = 4;

  private Clumping() {}

  /** Returns the factor of sums of echoes, at least 1. */
  public static double ofEchoes(Surprise surprise) {
    Blocks blocks = new Blocks(surprise.log);
    double[] sum = new double[blocks.count()];
    double[] variance = new double[blocks.count()];
    for (int i = 0; i < surprise.log.size(); i++) {
      sum[blocks.of(i)] += (surprise.log.echo(i) ? 1 : 0) - surprise.expected[i];
      variance[blocks.of(i)] += surprise.expected[i] * (1 - surprise.expected[i]);
    }
    return of(sum, variance, LEAST_VARIANCE);
  }

  /** Returns the factor of sums of where ranges lay in their distributions, at least 1. */
  public static double ofRanges(Surprise surprise) {
    Blocks blocks = new Blocks(surprise.log);
    double[] sum = new double[blocks.count()];
    double[] squares = new double[blocks.count()];
    for (int i = 0; i < surprise.log.size(); i++) {
      sum[blocks.of(i)] += surprise.score[i];
      squares[blocks.of(i)] += surprise.score[i] * surprise.score[i];
    }
    return of(sum, squares, LEAST_SQUARES);
  }

  /** Mean square of the blocks' sums of surprises, each in units of what chance gives. */
  private static double of(double[] sum, double[] variance, double least) {
    double[] square = new double[sum.length];
    int count = 0;
    for (int i = 0; i < sum.length; i++) {
      if (variance[i] > least) {
        square[count++] = sum[i] * sum[i] / variance[i];
      }
    }
    return count == 0 ? 1 : Math.max(1, Arrays.stream(square, 0, count).average().orElse(1));
  }
}
