package simbad.sonar.shape;

/**
 * The part of the plane that a sensor hears, whatever the distance: all directions within a half
 * angle of its heading.
 */
public final class Cone {
  /** As a share of a point's distance: a point so near the border lies on it. */
  private static final double ROUNDING = 1e-12;

  /** As a share of a distance: what is beyond by more is so whatever the rounding. */
  private static final double MARGIN = 1e-9;

  private final double halfAngleRad;
  private final double cos;
  private final double sin;

  /**
   * Creates a cone.
   *
   * @param halfAngleRad in (0, pi]; at pi it is the whole plane
   */
  public Cone(double halfAngleRad) {
    if (!(halfAngleRad > 0 && halfAngleRad <= Math.PI)) {
      throw new IllegalArgumentException("halfAngleRad = " + halfAngleRad + " is not in (0, pi]");
    }
    this.halfAngleRad = halfAngleRad;
    cos = Math.cos(halfAngleRad);
    sin = Math.sin(halfAngleRad);
  }

  /** Returns the half angle in radians. */
  public double halfAngleRad() {
    return halfAngleRad;
  }

  /**
   * Returns the distance from the cone's tip to the nearest point of an outline that lies in the
   * cone, its border included.
   *
   * <p>Exact: on each edge the nearest point of the part in the cone is the foot of the
   * perpendicular, an end, or where the edge meets the cone's border.
   *
   * @param outline in the frame of the tip
   * @param tipXM metres
   * @param tipZM metres
   * @param directionX x component of the heading, length 1 with the next
   * @param directionZ z component of the heading
   * @return metres; positive infinity, the least distance to nothing, when no point is in the cone
   */
  public double nearestM(
      Outline outline, double tipXM, double tipZM, double directionX, double directionZ) {
    double best = Double.POSITIVE_INFINITY;
    // An edge whose ends lie further away has no point that is nearer than the best.
    double far2 = Double.POSITIVE_INFINITY;
    int last = outline.size() - 1;
    double fromX = outline.xM(last) - tipXM;
    double fromZ = outline.zM(last) - tipZM;
    double fromAlong = fromX * directionX + fromZ * directionZ;
    double fromAcross = fromX * directionZ - fromZ * directionX;
    boolean wasNear = true;
    int wasBeyond = beyond(fromAlong, fromAcross);
    for (int i = 0; i <= last; i++) {
      double toX = outline.xM(i) - tipXM;
      double toZ = outline.zM(i) - tipZM;
      double along = toX * directionX + toZ * directionZ;
      double across = toX * directionZ - toZ * directionX;
      boolean near = along * along + across * across <= far2;
      int beyond = beyond(along, across);
      if ((wasNear || near) && (wasBeyond & beyond) == 0) {
        double nearest = nearestOfEdgeM(fromAlong, fromAcross, along, across, best);
        if (nearest < best) {
          best = nearest;
          double far = (best + outline.longestEdgeM() / 2) * (1 + MARGIN);
          far2 = far * far;
        }
      }
      fromAlong = along;
      fromAcross = across;
      wasNear = near;
      wasBeyond = beyond;
    }
    return best;
  }

  /** Beyond which borders a point lies for sure, of a cone that is no wider than a half plane. */
  private int beyond(double along, double across) {
    if (halfAngleRad >= Math.PI / 2) {
      return 0;
    }
    double inside = along * sin + MARGIN * (Math.abs(along) + Math.abs(across));
    return (across * cos > inside ? 1 : 0) | (-across * cos > inside ? 2 : 0);
  }

  /**
   * Returns whether a disc lies wholly outside the cone; quick to tell, and never true of a disc
   * that has a point in it.
   *
   * @param along of the disc's centre from the tip along the heading, metres
   * @param across of the disc's centre from the heading's line, metres, either sign
   * @param radiusM of the disc
   */
  public boolean misses(double along, double across, double radiusM) {
    if (halfAngleRad >= Math.PI / 2) {
      return false;
    }
    double side = Math.abs(across);
    // Beyond the border's line, or behind the tip: a little more than the radius for rounding.
    double clear = radiusM * (1 + 1e-9) + 1e-12;
    return side * cos - along * sin > clear || -along > clear;
  }

  /**
   * Returns whether a disc lies wholly in the cone; quick to tell, and never true of a disc that
   * has a point outside.
   *
   * @param along of the disc's centre from the tip along the heading, metres
   * @param across of the disc's centre from the heading's line, metres, either sign
   * @param radiusM of the disc
   */
  public boolean holds(double along, double across, double radiusM) {
    double clear = radiusM * (1 + 1e-9) + 1e-12;
    return halfAngleRad < Math.PI / 2 && along * sin - Math.abs(across) * cos > clear;
  }

  /** Coordinates along and across the heading; the tip is the origin. */
  private double nearestOfEdgeM(double a, double b, double toA, double toB, double bestM) {
    double ea = toA - a;
    double eb = toB - b;
    double t = footShare(-(a * ea + b * eb), ea * ea + eb * eb);
    double footA = a + t * ea;
    double footB = b + t * eb;
    double foot2 = footA * footA + footB * footB;
    if (foot2 >= bestM * bestM) {
      // No point of the edge is nearer than its foot.
      return bestM;
    }
    if (contains(footA, footB)) {
      return Math.sqrt(foot2);
    }
    double best = Math.min(endM(a, b), endM(toA, toB));
    best = Math.min(best, crossingM(a, b, ea, eb, sin));
    return Math.min(best, crossingM(a, b, ea, eb, -sin));
  }

  /** Where along an edge the perpendicular's foot is; most are at an end, without a division. */
  private static double footShare(double along, double length2) {
    if (along <= 0) {
      return 0;
    }
    return along >= length2 ? 1 : along / length2;
  }

  private double endM(double along, double across) {
    return contains(along, across)
        ? Math.sqrt(along * along + across * across)
        : Double.POSITIVE_INFINITY;
  }

  /** Where the edge (a, b) + t (ea, eb) meets the border ray (cos, side); t in [0, 1]. */
  private double crossingM(double a, double b, double ea, double eb, double side) {
    double parallel = ea * side - eb * cos;
    if (parallel == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double t = -(a * side - b * cos) / parallel;
    double distance = (a + t * ea) * cos + (b + t * eb) * side;
    return t >= 0 && t <= 1 && distance >= 0 ? distance : Double.POSITIVE_INFINITY;
  }

  private boolean contains(double along, double across) {
    if (halfAngleRad < Math.PI / 2) {
      double inside = along * sin - Math.abs(across) * cos;
      if (Math.abs(inside) > MARGIN * (Math.abs(along) + Math.abs(across))) {
        return inside > 0;
      }
    }
    double distance = Math.sqrt(along * along + across * across);
    return along >= cos * distance || onBorder(along, Math.abs(across), distance);
  }

  private boolean onBorder(double along, double aside, double distance) {
    return Math.abs(aside * cos - along * sin) <= ROUNDING * distance
        && along * cos + aside * sin > 0;
  }
}
