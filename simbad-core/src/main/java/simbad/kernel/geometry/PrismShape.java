package simbad.kernel.geometry;

import java.util.Arrays;
import simbad.sonar.check.Checks;

/**
 * An upright prism over a simple polygon, convex or not. Immutable.
 *
 * <p>The polygon lies in the plane y = 0 of the prism's own frame; it is closed (the last corner
 * joins the first) and may run either way round.
 */
public final class PrismShape implements Shape {
  /** Share of an edge by which a ray may pass its end: no ray slips through between two edges. */
  private static final double OVERLAP = 1e-12;

  private final double[] cornerX;
  private final double[] cornerZ;
  private final double bottomM;
  private final double topM;

  /**
   * Creates a prism.
   *
   * @param cornerX x of the corners, metres, at least 3; copied
   * @param cornerZ z of the corners, metres, as many; copied
   * @param bottomM height of the lower face in the prism's frame, metres
   * @param topM height of the upper face, metres; at least {@code bottomM}
   */
  public PrismShape(double[] cornerX, double[] cornerZ, double bottomM, double topM) {
    if (cornerX.length < 3 || cornerX.length != cornerZ.length) {
      throw new IllegalArgumentException(
          "corners = " + cornerX.length + " and " + cornerZ.length + " are not equal, at least 3");
    }
    Checks.numbers("cornerX", cornerX);
    Checks.numbers("cornerZ", cornerZ);
    if (!(bottomM <= topM)) {
      throw new IllegalArgumentException("topM = " + topM + " is not in [" + bottomM + ", inf)");
    }
    this.cornerX = cornerX.clone();
    this.cornerZ = cornerZ.clone();
    this.bottomM = bottomM;
    this.topM = topM;
  }

  /**
   * Returns an upright prism over a regular polygon, in its middle's frame, with a corner at -z.
   *
   * @param sides at least 3
   * @param radiusM distance of the corners from the axis, metres
   * @param heightM metres
   */
  public static PrismShape regular(int sides, double radiusM, double heightM) {
    Checks.notNegative("radiusM", radiusM);
    double[] x = new double[sides];
    double[] z = new double[sides];
    for (int i = 0; i < sides; i++) {
      double angle = 2 * Math.PI * i / sides;
      x[i] = -radiusM * Math.sin(angle);
      z[i] = -radiusM * Math.cos(angle);
    }
    return new PrismShape(x, z, -heightM / 2, heightM / 2);
  }

  /** Returns the number of corners. */
  public int corners() {
    return cornerX.length;
  }

  /** Returns the x coordinate of a corner in metres, in the prism's frame. */
  public double cornerX(int corner) {
    return cornerX[corner];
  }

  /** Returns the z coordinate of a corner in metres, in the prism's frame. */
  public double cornerZ(int corner) {
    return cornerZ[corner];
  }

  /** Returns the height of the lower face in metres, in the prism's frame. */
  public double bottomM() {
    return bottomM;
  }

  /** Returns the height of the upper face in metres, in the prism's frame. */
  public double topM() {
    return topM;
  }

  @Override
  public boolean strike(Ray ray) {
    boolean struck = strikeFace(ray, topM);
    struck |= strikeFace(ray, bottomM);
    int from = corners() - 1;
    for (int to = 0; to < corners(); to++) {
      struck |= strikeWall(ray, from, to);
      from = to;
    }
    return struck;
  }

  private boolean strikeWall(Ray ray, int from, int to) {
    double edgeX = cornerX[to] - cornerX[from];
    double edgeZ = cornerZ[to] - cornerZ[from];
    double cross = ray.directionX() * edgeZ - ray.directionZ() * edgeX;
    if (cross == 0) {
      return false;
    }
    double x = cornerX[from] - ray.originX();
    double z = cornerZ[from] - ray.originZ();
    double share = (x * ray.directionZ() - z * ray.directionX()) / cross;
    double distanceM = (x * edgeZ - z * edgeX) / cross;
    double y = ray.originY() + distanceM * ray.directionY();
    return share >= -OVERLAP
        && share <= 1 + OVERLAP
        && y >= bottomM
        && y <= topM
        && ray.shortenTo(distanceM);
  }

  private boolean strikeFace(Ray ray, double levelM) {
    if (ray.directionY() == 0) {
      return false;
    }
    double distanceM = (levelM - ray.originY()) * ray.inverseY();
    double x = ray.originX() + distanceM * ray.directionX();
    double z = ray.originZ() + distanceM * ray.directionZ();
    return (isInside(x, z) || isOnBorder(x, z)) && ray.shortenTo(distanceM);
  }

  private boolean isInside(double x, double z) {
    boolean inside = false;
    int from = corners() - 1;
    for (int to = 0; to < corners(); to++) {
      if (cornerZ[to] > z != cornerZ[from] > z && x < crossingX(from, to, z)) {
        inside = !inside;
      }
      from = to;
    }
    return inside;
  }

  /** The faces are closed: a ray that runs down along a wall meets the rim. */
  private boolean isOnBorder(double x, double z) {
    int from = corners() - 1;
    for (int to = 0; to < corners(); to++) {
      double edgeX = cornerX[to] - cornerX[from];
      double edgeZ = cornerZ[to] - cornerZ[from];
      double offX = x - cornerX[from];
      double offZ = z - cornerZ[from];
      double length2 = edgeX * edgeX + edgeZ * edgeZ;
      double along = offX * edgeX + offZ * edgeZ;
      double across = offX * edgeZ - offZ * edgeX;
      if (Math.abs(across) <= OVERLAP * length2 && along >= 0 && along <= length2) {
        return true;
      }
      from = to;
    }
    return false;
  }

  private double crossingX(int from, int to, double z) {
    double share = (z - cornerZ[from]) / (cornerZ[to] - cornerZ[from]);
    return cornerX[from] + share * (cornerX[to] - cornerX[from]);
  }

  @Override
  public void addTo(Extent extent, Placement worldFromShape) {
    for (int corner = 0; corner < corners(); corner++) {
      addCorner(extent, worldFromShape, corner, bottomM);
      addCorner(extent, worldFromShape, corner, topM);
    }
  }

  private void addCorner(Extent extent, Placement placement, int corner, double y) {
    double x = cornerX[corner];
    double z = cornerZ[corner];
    extent.include(placement.outerX(x, y, z), placement.outerY(x, y, z), placement.outerZ(x, y, z));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof PrismShape that
        && Arrays.equals(cornerX, that.cornerX)
        && Arrays.equals(cornerZ, that.cornerZ)
        && bottomM == that.bottomM
        && topM == that.topM;
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(cornerX) * 31 + Arrays.hashCode(cornerZ);
  }
}
