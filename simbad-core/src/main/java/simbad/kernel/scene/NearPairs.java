package simbad.kernel.scene;

import java.util.Arrays;

/**
 * Finds which balls of a set touch each other, by sweeping along x: balls that moved little since
 * the last sweep are nearly in order, so that a sweep costs little more than their number. Not safe
 * for use by several threads.
 */
public final class NearPairs {
  /** Receives each touching pair once, ordered by the lower index, then by the higher one. */
  @FunctionalInterface
  public interface Receiver {
    /** Takes the indices of two balls that touch. */
    void near(int lower, int higher);
  }

  private static final int STRIDE = 4;
  private double[] balls = {};
  private int[] order = {};
  private int count;
  private long[] pairs = new long[8];
  private int pairCount;

  /** Creates a finder without balls. */
  public NearPairs() {}

  /** Sets how many balls there are; they keep their places where the number is unchanged. */
  public void resize(int newCount) {
    if (newCount != count) {
      count = newCount;
      balls = new double[newCount * STRIDE];
      order = new int[newCount];
      Arrays.setAll(order, i -> i);
    }
  }

  /** Places a ball, centre in metres. */
  public void setCentre(int ball, double xM, double yM, double zM) {
    balls[ball * STRIDE] = xM;
    balls[ball * STRIDE + 1] = yM;
    balls[ball * STRIDE + 2] = zM;
  }

  /** Sets the radius of a ball in metres; at least 0. */
  public void setRadius(int ball, double radiusM) {
    balls[ball * STRIDE + 3] = radiusM;
  }

  /** Reports every pair whose centres are no further apart than the sum of the radii. */
  public void sweep(Receiver receiver) {
    sort();
    pairCount = 0;
    for (int i = 0; i < count; i++) {
      int one = order[i];
      for (int j = i + 1; j < count && leastX(order[j]) <= greatestX(one); j++) {
        collect(one, order[j]);
      }
    }
    Arrays.sort(pairs, 0, pairCount);
    for (int i = 0; i < pairCount; i++) {
      receiver.near((int) (pairs[i] >> 32), (int) pairs[i]);
    }
  }

  private void collect(int one, int other) {
    if (touch(one, other)) {
      if (pairCount == pairs.length) {
        pairs = Arrays.copyOf(pairs, 2 * pairCount);
      }
      pairs[pairCount++] = (long) Math.min(one, other) << 32 | Math.max(one, other);
    }
  }

  private void sort() {
    for (int i = 1; i < count; i++) {
      int ball = order[i];
      int at = i;
      while (at > 0 && leastX(order[at - 1]) > leastX(ball)) {
        order[at] = order[at - 1];
        at--;
      }
      order[at] = ball;
    }
  }

  private double leastX(int ball) {
    return balls[ball * STRIDE] - balls[ball * STRIDE + 3];
  }

  private double greatestX(int ball) {
    return balls[ball * STRIDE] + balls[ball * STRIDE + 3];
  }

  private boolean touch(int one, int other) {
    int a = one * STRIDE;
    int b = other * STRIDE;
    double dx = balls[a] - balls[b];
    double dy = balls[a + 1] - balls[b + 1];
    double dz = balls[a + 2] - balls[b + 2];
    double reach = balls[a + 3] + balls[b + 3];
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  }
}
