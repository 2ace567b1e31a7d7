package simbad.kernel.drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Cuts a simple polygon, convex or not, into triangles by clipping ears (Meisters, "Polygons have
 * ears", 1975).
 */
final class PolygonTriangles {
  private final double[] x;
  private final double[] z;
  private final List<Integer> left;
  private final IntStream.Builder found = IntStream.builder();

  private PolygonTriangles(double[] x, double[] z) {
    this.x = x;
    this.z = z;
    left = new ArrayList<>(IntStream.range(0, x.length).boxed().toList());
  }

  /**
   * Returns three corners per triangle, counter-clockwise as seen from above (x right, z down).
   *
   * @param x of the corners, counter-clockwise as seen from above
   * @param z of the corners
   */
  static int[] of(double[] x, double[] z) {
    PolygonTriangles triangles = new PolygonTriangles(x, z);
    while (triangles.left.size() > 2) {
      triangles.clip();
    }
    return triangles.found.build().toArray();
  }

  /** Cuts an ear off; where rounding leaves none, any corner. */
  private void clip() {
    int ear = IntStream.range(0, left.size()).filter(this::isEar).findFirst().orElse(0);
    IntStream.rangeClosed(-1, 1).map(offset -> corner(ear + offset)).forEach(found::add);
    left.remove(ear);
  }

  private int corner(int index) {
    return left.get(Math.floorMod(index, left.size()));
  }

  private boolean isEar(int index) {
    int a = corner(index - 1);
    int b = corner(index);
    int c = corner(index + 1);
    return turn(a, b, c) > 0
        && left.stream()
            .filter(p -> p != a && p != b && p != c)
            .noneMatch(p -> turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0);
  }

  /** Positive if three corners turn left as seen from above. */
  private double turn(int a, int b, int c) {
    return (x[a] - x[b]) * (z[c] - z[a]) - (z[a] - z[b]) * (x[c] - x[a]);
  }
}
