package simbad.sonar.shape;

/** Tells whether two cross-sections lie over each other. */
public final class Overlap {
  private Overlap() {}

  /**
   * Tells whether two outlines in one frame cross each other or one holds the other; those that
   * touch do not overlap.
   *
   * @param one closed polygon
   * @param other another
   */
  public static boolean of(Outline one, Outline other) {
    for (int i = 0; i < one.size(); i++) {
      for (int j = 0; j < other.size(); j++) {
        if (crosses(one, i, other, j)) {
          return true;
        }
      }
    }
    return holdsMiddle(one, other) || holdsMiddle(other, one);
  }

  /** Without crossing edges one point of a body tells of all of it; a corner may only touch. */
  private static boolean holdsMiddle(Outline outer, Outline inner) {
    for (int i = 0; i < inner.size(); i++) {
      int next = (i + 1) % inner.size();
      double x = (inner.xM(i) + inner.xM(next)) / 2;
      double z = (inner.zM(i) + inner.zM(next)) / 2;
      if (outer.distanceM(x, z) > 0) {
        return contains(outer, x, z);
      }
    }
    return true; // The same outline twice.
  }

  private static boolean contains(Outline outline, double x, double z) {
    boolean inside = false;
    for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      boolean spans = outline.zM(i) > z != outline.zM(j) > z;
      if (spans) {
        double share = (z - outline.zM(i)) / (outline.zM(j) - outline.zM(i));
        inside ^= x < outline.xM(i) + share * (outline.xM(j) - outline.xM(i));
      }
    }
    return inside;
  }

  private static boolean crosses(Outline a, int i, Outline b, int j) {
    int i2 = (i + 1) % a.size();
    int j2 = (j + 1) % b.size();
    return side(a, i, i2, b, j) * side(a, i, i2, b, j2) < 0
        && side(b, j, j2, a, i) * side(b, j, j2, a, i2) < 0;
  }

  private static double side(Outline line, int from, int to, Outline other, int at) {
    return (line.xM(to) - line.xM(from)) * (other.zM(at) - line.zM(from))
        - (line.zM(to) - line.zM(from)) * (other.xM(at) - line.xM(from));
  }
}
