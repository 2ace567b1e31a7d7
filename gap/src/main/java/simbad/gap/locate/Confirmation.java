package simbad.gap.locate;

import java.util.function.IntPredicate;
import java.util.stream.DoubleStream;
import org.hipparchus.special.Erf;
import simbad.gap.score.Blocks;

/** Tests slices on pings that they were not found on. */
final class Confirmation {
  private Confirmation() {}

  /**
   * Computes the probability of as large an excess where there is none.
   *
   * <p>The mean is set against the scatter of the pings about 0, widened by how much more the sums
   * over blocks scatter than those of independent pings would.
   *
   * @param excess of each ping, of mean 0 where there is none
   * @param blocks that belong together
   * @param holds tells which pings are in the slice
   * @return 1 where no ping is
   */
  static double chance(double[] excess, Blocks blocks, IntPredicate holds) {
    double[] sum = new double[blocks.count()];
    double[] squares = new double[blocks.count()];
    for (int ping = 0; ping < excess.length; ping++) {
      if (holds.test(ping)) {
        sum[blocks.of(ping)] += excess[ping];
        squares[blocks.of(ping)] += excess[ping] * excess[ping];
      }
    }
    double scatter = DoubleStream.of(squares).sum();
    if (!(scatter > 0)) {
      return 1;
    }
    double total = DoubleStream.of(sum).sum();
    double clumping = clumping(sum, squares, total, scatter);
    return Erf.erfc(total / Math.sqrt(2 * scatter * clumping)) / 2;
  }

  /** A block is expected to hold as much of the total as of the scatter: where much is at stake. */
  private static double clumping(double[] sum, double[] squares, double total, double scatter) {
    double between = 0;
    int used = 0;
    for (int block = 0; block < sum.length; block++) {
      if (squares[block] > 0) {
        double off = sum[block] - total * squares[block] / scatter;
        between += off * off;
        used++;
      }
    }
    return used > 1 ? Math.max(1, between / scatter * used / (used - 1)) : 1;
  }
}
