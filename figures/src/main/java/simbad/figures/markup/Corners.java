package simbad.figures.markup;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;

/**
 * Which corners a curve needs: those left out lie within a tolerance of the curve that is left
 * (Douglas and Peucker 1973, Cartographica 10, 112).
 */
public final class Corners {
  private final double[] x;
  private final double[] y;

  private Corners(double[] x, double[] y) {
    this.x = x;
    this.y = y;
  }

  /**
   * Finds the corners that are needed; first and last always are.
   *
   * @param x of each corner; at least one
   * @param y of each corner, as many
   * @param tolerance how far the curve may move, in the same unit
   */
  public static BitSet needed(double[] x, double[] y, double tolerance) {
    return new Corners(x, y).needed(tolerance);
  }

  private BitSet needed(double tolerance) {
    BitSet kept = new BitSet();
    kept.set(0);
    kept.set(x.length - 1);
    Deque<int[]> spans = new ArrayDeque<>();
    spans.push(new int[] {0, x.length - 1});
    while (!spans.isEmpty()) {
      int[] span = spans.pop();
      int far = farthest(span[0], span[1]);
      if (far >= 0 && distance(far, span[0], span[1]) > tolerance) {
        kept.set(far);
        spans.push(new int[] {span[0], far});
        spans.push(new int[] {far, span[1]});
      }
    }
    return kept;
  }

  /** The index strictly between two others that lies farthest from their edge, or -1. */
  private int farthest(int from, int to) {
    int best = -1;
    double bestDistance = -1;
    for (int i = from + 1; i < to; i++) {
      double distance = distance(i, from, to);
      if (distance > bestDistance) {
        bestDistance = distance;
        best = i;
      }
    }
    return best;
  }

  private double distance(int i, int from, int to) {
    double dx = x[to] - x[from];
    double dy = y[to] - y[from];
    double length2 = dx * dx + dy * dy;
    double along = (x[i] - x[from]) * dx + (y[i] - y[from]) * dy;
    double t = length2 == 0 ? 0 : Math.max(0, Math.min(1, along / length2));
    return Math.hypot(x[i] - x[from] - t * dx, y[i] - y[from] - t * dy);
  }
}
