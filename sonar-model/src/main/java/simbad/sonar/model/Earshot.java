package simbad.sonar.model;

import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * The obstacles that may be heard at a place that moves on little by little. They are gathered from
 * somewhat farther around and kept until the place has moved out of that, so that the tree is asked
 * only now and then. A mutable buffer; not safe for use by several threads.
 */
final class Earshot<T extends PlacedObstacle> {
  /**
   * How far the place may move before the tree is asked again, as a share of the greatest earshot.
   */
  private static final double SLACK = 0.125;

  private final T[] obstacles;
  private final EarshotTree tree;
  private final double slackM;
  private final IntConsumer gathering = this::add;
  private T[] near;
  private int size;
  private boolean gathered;
  private double fromXM;
  private double fromZM;

  Earshot(T[] obstacles, double[] earshotM) {
    this.obstacles = obstacles;
    tree = new EarshotTree(obstacles, earshotM);
    slackM = SLACK * tree.greatestM();
    near = Arrays.copyOf(obstacles, Math.min(8, obstacles.length));
  }

  private void add(int obstacle) {
    if (size == near.length) {
      near = Arrays.copyOf(near, Math.min(2 * size, obstacles.length));
    }
    near[size++] = obstacles[obstacle];
  }

  /** Moves to a place; afterwards all obstacles that may be heard there are here. */
  void moveTo(double xM, double zM) {
    double dx = xM - fromXM;
    double dz = zM - fromZM;
    if (!gathered || !(dx * dx + dz * dz <= slackM * slackM)) {
      size = 0;
      tree.find(xM, zM, slackM * (1 + 1e-9), gathering);
      fromXM = xM;
      fromZM = zM;
      gathered = true;
    }
  }

  /** Returns how many obstacles there are. */
  int size() {
    return size;
  }

  /** Returns one of them; in no order. */
  T get(int index) {
    return near[index];
  }
}
