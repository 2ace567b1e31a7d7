package simbad.sonar.model;

import java.util.Comparator;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * Finds the obstacles that may be heard at a place. Each has an earshot: the disc round its centre
 * outside of which nothing hears it. A balanced tree of boxes round these discs: asking takes about
 * the logarithm of their number, and as much again for each one found. Immutable.
 */
final class EarshotTree {
  /** How many obstacles a box holds that is not divided any more. */
  private static final int FEW = 4;

  /** Added to each earshot, as a share of it, so that rounding loses no obstacle at its rim. */
  private static final double ROUNDING = 1e-9;

  private static final int SIDES = 4;

  private final PlacedObstacle[] obstacles;
  private final double[] earshotM;
  private final int[] order;

  /**
   * Least x, least z, greatest x, greatest z of one box after another; those in box i: 2i+1, 2i+2.
   */
  private final double[] boxes;

  /** Where in the order the obstacles of a box begin, and where they have ended. */
  private final int[] from;

  private final int[] until;

  /**
   * Builds the tree.
   *
   * @param obstacles what may be heard
   * @param earshotM of each in metres, in the same order
   */
  EarshotTree(PlacedObstacle[] obstacles, double[] earshotM) {
    this.obstacles = obstacles;
    this.earshotM = earshotM;
    order = IntStream.range(0, obstacles.length).toArray();
    int least = Math.max(1, (obstacles.length + FEW - 1) / FEW);
    int most = 4 * Integer.highestOneBit(least);
    boxes = new double[SIDES * most];
    from = new int[most];
    until = new int[most];
    divide(0, 0, order.length);
  }

  private void divide(int box, int first, int end) {
    from[box] = first;
    until[box] = end;
    enclose(box, first, end);
    if (end - first > FEW) {
      int at = SIDES * box;
      boolean wide = boxes[at + 2] - boxes[at] > boxes[at + 3] - boxes[at + 1];
      sort(first, end, wide);
      int middle = (first + end) >>> 1;
      divide(2 * box + 1, first, middle);
      divide(2 * box + 2, middle, end);
    }
  }

  private void enclose(int box, int first, int end) {
    double leastX = Double.POSITIVE_INFINITY;
    double leastZ = Double.POSITIVE_INFINITY;
    double greatestX = Double.NEGATIVE_INFINITY;
    double greatestZ = Double.NEGATIVE_INFINITY;
    for (int i = first; i < end; i++) {
      PlacedObstacle obstacle = obstacles[order[i]];
      double radius = earshotM[order[i]] * (1 + ROUNDING);
      leastX = Math.min(leastX, obstacle.xM() - radius);
      leastZ = Math.min(leastZ, obstacle.zM() - radius);
      greatestX = Math.max(greatestX, obstacle.xM() + radius);
      greatestZ = Math.max(greatestZ, obstacle.zM() + radius);
    }
    int at = SIDES * box;
    boxes[at] = leastX;
    boxes[at + 1] = leastZ;
    boxes[at + 2] = greatestX;
    boxes[at + 3] = greatestZ;
  }

  private void sort(int first, int end, boolean byX) {
    int[] sorted =
        IntStream.range(first, end)
            .mapToObj(i -> order[i])
            .sorted(Comparator.comparingDouble(i -> byX ? obstacles[i].xM() : obstacles[i].zM()))
            .mapToInt(i -> i)
            .toArray();
    System.arraycopy(sorted, 0, order, first, sorted.length);
  }

  /** Returns the greatest earshot in metres; 0 without obstacles. */
  double greatestM() {
    double greatest = 0;
    for (double earshot : earshotM) {
      greatest = Math.max(greatest, earshot);
    }
    return greatest;
  }

  /**
   * Reports the index of every obstacle whose earshot is no further than a way from a place; in no
   * order. Allocates nothing.
   */
  void find(double xM, double zM, double withinM, IntConsumer found) {
    find(0, xM, zM, withinM, found);
  }

  private void find(int box, double xM, double zM, double withinM, IntConsumer found) {
    if (!reaches(SIDES * box, xM, zM, withinM)) {
      return;
    }
    if (until[box] - from[box] > FEW) {
      find(2 * box + 1, xM, zM, withinM, found);
      find(2 * box + 2, xM, zM, withinM, found);
      return;
    }
    for (int i = from[box]; i < until[box]; i++) {
      int obstacle = order[i];
      double reach = earshotM[obstacle] * (1 + ROUNDING) + withinM;
      if (obstacles[obstacle].centreDistanceM(xM, zM) <= reach) {
        found.accept(obstacle);
      }
    }
  }

  private boolean reaches(int at, double xM, double zM, double withinM) {
    return xM >= boxes[at] - withinM
        && zM >= boxes[at + 1] - withinM
        && xM <= boxes[at + 2] + withinM
        && zM <= boxes[at + 3] + withinM;
  }
}
