package simbad.kernel.render;

/**
 * Cuts triangles at the planes of a frustum (Sutherland and Hodgman, "Reentrant polygon clipping",
 * 1974).
 */
final class Clipper {
  /** A triangle gets at most one corner more per plane. */
  private static final int MOST_CORNERS = 3 + Frustum.PLANES;

  private final Frustum frustum;
  private Vertices polygon = new Vertices();
  private Vertices cut = new Vertices();
  private int corners;

  Clipper(Frustum frustum) {
    this.frustum = frustum;
    polygon.reserve(MOST_CORNERS);
    cut.reserve(MOST_CORNERS);
  }

  /** Cuts a triangle; what is left is in {@link #polygon()}. */
  void clip(Vertices from, int a, int b, int c) {
    polygon.copy(0, from, a);
    polygon.copy(1, from, b);
    polygon.copy(2, from, c);
    corners = 3;
    for (int plane = 0; plane < Frustum.PLANES && corners > 0; plane++) {
      if (isCut(plane)) {
        cutAt(plane);
      }
    }
  }

  private boolean isCut(int plane) {
    for (int i = 0; i < corners; i++) {
      if (inside(plane, i) < 0) {
        return true;
      }
    }
    return false;
  }

  private double inside(int plane, int i) {
    return frustum.inside(plane, polygon.depthM(i), polygon.rightM(i), polygon.upM(i));
  }

  private void cutAt(int plane) {
    int kept = 0;
    for (int i = 0; i < corners; i++) {
      int next = i + 1 == corners ? 0 : i + 1;
      double here = inside(plane, i);
      double there = inside(plane, next);
      if (here >= 0) {
        cut.copy(kept++, polygon, i);
      }
      if (here >= 0 != there >= 0) {
        mixInside(kept++, i, next, here, there);
      }
    }
    Vertices swap = polygon;
    polygon = cut;
    cut = swap;
    corners = kept;
  }

  /** Cuts an edge always from its inner end, so that neighbours get the same vertex. */
  private void mixInside(int to, int i, int next, double here, double there) {
    if (here >= 0) {
      cut.mix(to, polygon, i, next, here / (here - there));
    } else {
      cut.mix(to, polygon, next, i, there / (there - here));
    }
  }

  /** Returns what was left of the last triangle: a convex polygon. */
  Vertices polygon() {
    return polygon;
  }

  /** Returns the number of corners that were left: 0, or at least 3. */
  int corners() {
    return corners;
  }
}
