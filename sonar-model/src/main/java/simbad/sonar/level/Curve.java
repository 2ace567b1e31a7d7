package simbad.sonar.level;

import java.util.Arrays;

/**
 * A curve through points: straight between them, constant beyond the first and the last. Immutable.
 */
public final class Curve {
  private final double[] x;
  private final double[] y;
  private final double least;
  private final double greatest;

  /** Pieces to a unit of x, on the average. */
  private final double perUnit;

  private Curve(double[] x, double[] y) {
    this.x = x;
    this.y = y;
    perUnit = x.length == 1 ? 0 : (x.length - 1) / (x[x.length - 1] - x[0]);
    least = Arrays.stream(y).min().orElseThrow();
    greatest = Arrays.stream(y).max().orElseThrow();
  }

  /**
   * Creates a curve.
   *
   * @param points x and y in turn: x0, y0, x1, y1 ...; at least one point, all finite, x rising
   * @throws IllegalArgumentException if there is no point, a number is not finite, or x does not
   *     rise
   */
  public static Curve of(double... points) {
    if (points.length == 0 || points.length % 2 != 0) {
      throw new IllegalArgumentException(
          "points = " + points.length + " numbers; a curve has two for each of at least one point");
    }
    double[] x = new double[points.length / 2];
    double[] y = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      x[i] = finite(points[2 * i]);
      y[i] = finite(points[2 * i + 1]);
      if (i > 0 && !(x[i] > x[i - 1])) {
        throw new IllegalArgumentException("x = " + x[i] + " does not rise from " + x[i - 1]);
      }
    }
    return new Curve(x, y);
  }

  private static double finite(double number) {
    if (!(Math.abs(number) < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(number + " in a curve is not finite");
    }
    return number;
  }

  /**
   * Creates a curve that has one value everywhere.
   *
   * @param value finite
   */
  public static Curve constant(double value) {
    return of(0, value);
  }

  /** Returns the number of points. */
  public int size() {
    return x.length;
  }

  /**
   * Returns where a point lies.
   *
   * @param index from 0
   */
  public double x(int index) {
    return x[index];
  }

  /**
   * Returns the value at a point.
   *
   * @param index from 0
   */
  public double y(int index) {
    return y[index];
  }

  /** Returns the least value. */
  public double least() {
    return least;
  }

  /** Returns the greatest value. */
  public double greatest() {
    return greatest;
  }

  /**
   * Returns the value at any place.
   *
   * @param at any number, infinities included
   */
  public double at(double at) {
    int last = x.length - 1;
    if (!(at > x[0])) {
      return y[0];
    }
    if (at >= x[last]) {
      return y[last];
    }
    int low = piece(at, last);
    int high = low + 1;
    return y[low] + (y[high] - y[low]) * (at - x[low]) / (x[high] - x[low]);
  }

  /** The piece that holds a place between the ends: most curves have pieces of one width. */
  private int piece(double at, int last) {
    int guess = Math.min(last - 1, (int) ((at - x[0]) * perUnit));
    if (x[guess] <= at && at < x[guess + 1]) {
      return guess;
    }
    int low = 0;
    int high = last;
    while (high - low > 1) {
      int middle = (low + high) >>> 1;
      if (x[middle] <= at) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Curve that && Arrays.equals(x, that.x) && Arrays.equals(y, that.y);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(x) + Arrays.hashCode(y);
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("Curve");
    for (int i = 0; i < x.length; i++) {
      text.append(i == 0 ? "[[" : ", [").append(x[i]).append(", ").append(y[i]).append(']');
    }
    return text.append(']').toString();
  }
}
