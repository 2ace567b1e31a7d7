package simbad.obstacles;

/**
 * A sensor's cone on the plane, as long as its greatest range: apex, heading, half-angle below a
 * right angle, radius. Written for the tests without the product's geometry.
 */
record Sector(double x, double z, double headingRad, double halfAngleRad, double radiusM) {

  /** Whether it shares a point with the triangle of three corners x, z. */
  boolean overlaps(double[] a, double[] b, double[] c) {
    // One lies in the other, or their borders cross: a border is two straight sides and an arc.
    return holds(a[0], a[1]) || isIn(a, b, c) || isCutBy(a, b) || isCutBy(b, c) || isCutBy(c, a);
  }

  private boolean holds(double px, double pz) {
    return Math.hypot(px - x, pz - z) <= radiusM && isAhead(px, pz);
  }

  private boolean isAhead(double px, double pz) {
    double off = Math.atan2(-(pz - z), px - x) - headingRad;
    return Math.abs(Math.IEEEremainder(off, 2 * Math.PI)) <= halfAngleRad;
  }

  /** The apex lies in a triangle that has an area: on the same side of all three edges. */
  private boolean isIn(double[] a, double[] b, double[] c) {
    double ab = side(a, b, x, z);
    double bc = side(b, c, x, z);
    double ca = side(c, a, x, z);
    boolean hasArea = Math.abs(side(a, b, c[0], c[1])) > 1e-12;
    return hasArea && ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0));
  }

  private static double side(double[] from, double[] to, double px, double pz) {
    return (to[0] - from[0]) * (pz - from[1]) - (to[1] - from[1]) * (px - from[0]);
  }

  private boolean isCutBy(double[] from, double[] to) {
    return crosses(from, to, headingRad + halfAngleRad)
        || crosses(from, to, headingRad - halfAngleRad)
        || meetsArc(from, to);
  }

  /** The straight side along a heading crosses a piece. */
  private boolean crosses(double[] from, double[] to, double alongRad) {
    double[] apex = {x, z};
    double[] end = {x + radiusM * Math.cos(alongRad), z - radiusM * Math.sin(alongRad)};
    return side(from, to, apex[0], apex[1]) * side(from, to, end[0], end[1]) <= 0
        && side(apex, end, from[0], from[1]) * side(apex, end, to[0], to[1]) <= 0;
  }

  /** |from + t (to - from) - apex| = radius, solved for t in [0, 1], within the angle. */
  private boolean meetsArc(double[] from, double[] to) {
    double ax = from[0] - x;
    double az = from[1] - z;
    double ex = to[0] - from[0];
    double ez = to[1] - from[1];
    double square = ex * ex + ez * ez;
    double half = ax * ex + az * ez;
    double root = Math.sqrt(half * half - square * (ax * ax + az * az - radiusM * radiusM));
    return isOnArc(from, ex, ez, (-half - root) / square)
        || isOnArc(from, ex, ez, (-half + root) / square);
  }

  /** Without a real solution t is NaN, and nothing is met. */
  private boolean isOnArc(double[] from, double ex, double ez, double t) {
    return t >= 0 && t <= 1 && isAhead(from[0] + t * ex, from[1] + t * ez);
  }
}
