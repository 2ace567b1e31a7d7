package simbad.kernel.geometry;

import simbad.sonar.check.Checks;

/**
 * A box along the axes of its own frame, its middle at the origin. All faces belong to it: a level
 * ray in the plane of the top face meets the box.
 *
 * @param halfXM half the side along x, metres; finite, at least 0
 * @param halfYM half the height, metres; finite, at least 0
 * @param halfZM half the side along z, metres; finite, at least 0
 */
public record BoxShape(double halfXM, double halfYM, double halfZM) implements Shape {
  /** Further away than any surface of a world, yet finite. */
  private static final double FAR = 1e300;

  /** Checks the sides. */
  public BoxShape {
    Checks.notNegative("halfXM", halfXM);
    Checks.notNegative("halfYM", halfYM);
    Checks.notNegative("halfZM", halfZM);
  }

  /** Creates a box from its full sides in metres. */
  public static BoxShape ofSides(double xM, double yM, double zM) {
    return new BoxShape(xM / 2, yM / 2, zM / 2);
  }

  @Override
  public boolean strike(Ray ray) {
    double reachX = reach(ray.originX(), ray.directionX(), ray.inverseX(), halfXM);
    double reachY = reach(ray.originY(), ray.directionY(), ray.inverseY(), halfYM);
    double reachZ = reach(ray.originZ(), ray.directionZ(), ray.inverseZ(), halfZM);
    double midX = middle(ray.originX(), ray.directionX(), ray.inverseX());
    double midY = middle(ray.originY(), ray.directionY(), ray.inverseY());
    double midZ = middle(ray.originZ(), ray.directionZ(), ray.inverseZ());
    double enter = Math.max(midX - reachX, Math.max(midY - reachY, midZ - reachZ));
    double exit = Math.min(midX + reachX, Math.min(midY + reachY, midZ + reachZ));
    return enter <= exit && ray.shortenTo(enter >= 0 ? enter : exit);
  }

  /** Half the stretch of the ray between two faces; negative if it runs beside them. */
  private static double reach(double origin, double direction, double inverse, double half) {
    if (direction == 0) {
      return Math.abs(origin) <= half ? FAR : -FAR;
    }
    return Math.abs(inverse) * half;
  }

  private static double middle(double origin, double direction, double inverse) {
    return direction == 0 ? 0 : -origin * inverse;
  }

  @Override
  public void addTo(Extent extent, Placement worldFromShape) {
    extent.includeAround(
        worldFromShape,
        halfSpan(worldFromShape, 0),
        halfSpan(worldFromShape, 1),
        halfSpan(worldFromShape, 2));
  }

  private double halfSpan(Placement placement, int row) {
    return Math.abs(placement.rotation(row, 0)) * halfXM
        + Math.abs(placement.rotation(row, 1)) * halfYM
        + Math.abs(placement.rotation(row, 2)) * halfZM;
  }
}
