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
    boxes = new double[SIDES * 4 * Integer.highestOneBit(least)];
    divide(0, 0, order.length);
  }

  private void divide(int box, int from, int to) {
    enclose(box, from, to);
    if (to - from > FEW) {
      int at = SIDES * box;
      boolean wide = boxes[at + 2] - boxes[at] > boxes[at + 3] - boxes[at + 1];
      sort(from, to, wide);
      int middle = (from + to) >>> 1;
      divide(2 * box + 1, from, middle);
      divide(2 * box + 2, middle, to);
    }
  }

  private void enclose(int box, int from, int to) {
    double leastX = Double.POSITIVE_INFINITY;
    double leastZ = Double.POSITIVE_INFINITY;
    double greatestX = Double.NEGATIVE_INFINITY;
    double greatestZ = Double.NEGATIVE_INFINITY;
    for (int i = from; i < to; i++) {
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

  private void sort(int from, int to, boolean byX) {
    int[] sorted =
        IntStream.range(from, to)
            .mapToObj(i -> order[i])
            .sorted(Comparator.comparingDouble(i -> byX ? obstacles[i].xM() : obstacles[i].zM()))
            .mapToInt(i -> i)
            .toArray();
    System.arraycopy(sorted, 0, order, from, sorted.length);
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
   * Reports the index of every obstacle whose earshot is no further than a way from a place, and
   * maybe of some a little beyond; in no order.
   */
  void find(double xM, double zM, double withinM, IntConsumer found) {
    find(new Query(xM, zM, withinM, found), 0, 0, order.length);
  }

  private void find(Query query, int box, int from, int to) {
    if (!query.reaches(boxes, SIDES * box)) {
      return;
    }
    if (to - from > FEW) {
      int middle = (from + to) >>> 1;
      find(query, 2 * box + 1, from, middle);
      find(query, 2 * box + 2, middle, to);
      return;
    }
    for (int i = from; i < to; i++) {
      int obstacle = order[i];
      double reach = earshotM[obstacle] * (1 + ROUNDING) + query.withinM;
      if (obstacles[obstacle].centreDistanceM(query.xM, query.zM) <= reach) {
        query.found.accept(obstacle);
      }
    }
  }

  private record Query(double xM, double zM, double withinM, IntConsumer found) {
    boolean reaches(double[] boxes, int at) {
      return xM >= boxes[at] - withinM
          && zM >= boxes[at + 1] - withinM
          && xM <= boxes[at + 2] + withinM
          && zM <= boxes[at + 3] + withinM;
    }
  }
}
