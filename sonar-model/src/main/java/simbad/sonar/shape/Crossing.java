package simbad.sonar.shape;

import java.util.Optional;

/**
 * Two edges of an outline that touch where they should not.
 *
 * @param firstEdge index of an edge; edge i goes from corner i to the next
 * @param secondEdge index of the other
 */
public record Crossing(int firstEdge, int secondEdge) {
  /**
   * Finds the first place at which an outline crosses or touches itself.
   *
   * @param outline to look at
   * @return empty for a simple polygon
   */
  public static Optional<Crossing> find(Outline outline) {
    return first(outline, Crossing::meet);
  }

  /**
   * Finds the first place at which an outline crosses itself; one that only touches itself, as
   * bodies that are joined by a line of no width do, passes.
   *
   * @param outline to look at
   */
  public static Optional<Crossing> findCrossed(Outline outline) {
    return first(outline, Crossing::cross);
  }

  /** Tells of two edges of an outline. */
  private interface EdgeTest {
    boolean holds(Outline outline, int i, int j);
  }

  private static Optional<Crossing> first(Outline outline, EdgeTest test) {
    int n = outline.size();
    for (int i = 0; i < n; i++) {
      for (int j = i + 2; j < n; j++) {
        boolean neighbours = i == 0 && j == n - 1;
        if (!neighbours && test.holds(outline, i, j)) {
          return Optional.of(new Crossing(i, j));
        }
      }
    }
    return Optional.empty();
  }

  private static boolean meet(Outline o, int i, int j) {
    int i2 = (i + 1) % o.size();
    int j2 = (j + 1) % o.size();
    double a = side(o, i, i2, j);
    double b = side(o, i, i2, j2);
    double c = side(o, j, j2, i);
    double d = side(o, j, j2, i2);
    return (a * b < 0 && c * d < 0)
        || (a == 0 && between(o, i, i2, j))
        || (b == 0 && between(o, i, i2, j2))
        || (c == 0 && between(o, j, j2, i))
        || (d == 0 && between(o, j, j2, i2));
  }

  private static boolean cross(Outline o, int i, int j) {
    int i2 = (i + 1) % o.size();
    int j2 = (j + 1) % o.size();
    return side(o, i, i2, j) * side(o, i, i2, j2) < 0 && side(o, j, j2, i) * side(o, j, j2, i2) < 0;
  }

  private static double side(Outline o, int from, int to, int at) {
    return (o.xM(to) - o.xM(from)) * (o.zM(at) - o.zM(from))
        - (o.zM(to) - o.zM(from)) * (o.xM(at) - o.xM(from));
  }

  private static boolean between(Outline o, int from, int to, int at) {
    return o.xM(at) >= Math.min(o.xM(from), o.xM(to))
        && o.xM(at) <= Math.max(o.xM(from), o.xM(to))
        && o.zM(at) >= Math.min(o.zM(from), o.zM(to))
        && o.zM(at) <= Math.max(o.zM(from), o.zM(to));
  }
}
