package simbad.kernel.geometry;

/**
 * A box along the axes of the world frame that grows to hold what is put into it. Empty when made.
 * A mutable buffer; not safe for use by several threads.
 */
public final class Extent {
  private double minX;
  private double minY;
  private double minZ;
  private double maxX;
  private double maxY;
  private double maxZ;

  /** Creates an empty extent. */
  public Extent() {
    clear();
  }

  /** Becomes empty. */
  public void clear() {
    minX = Double.POSITIVE_INFINITY;
    minY = Double.POSITIVE_INFINITY;
    minZ = Double.POSITIVE_INFINITY;
    maxX = Double.NEGATIVE_INFINITY;
    maxY = Double.NEGATIVE_INFINITY;
    maxZ = Double.NEGATIVE_INFINITY;
  }

  /** Grows to hold a point in metres. */
  public void include(double xM, double yM, double zM) {
    minX = lesser(minX, xM);
    minY = lesser(minY, yM);
    minZ = lesser(minZ, zM);
    maxX = greater(maxX, xM);
    maxY = greater(maxY, yM);
    maxZ = greater(maxZ, zM);
  }

  /** Grows to hold another extent; an empty one changes nothing. */
  public void include(Extent other) {
    include(other.minX, other.minY, other.minZ);
    include(other.maxX, other.maxY, other.maxZ);
  }

  /** Grows to hold the box round a placement's origin with given half sides in metres. */
  void includeAround(Placement centre, double halfX, double halfY, double halfZ) {
    include(centre.xM() - halfX, centre.yM() - halfY, centre.zM() - halfZ);
    include(centre.xM() + halfX, centre.yM() + halfY, centre.zM() + halfZ);
  }

  /** Grows by a margin in metres on all sides. */
  public void grow(double marginM) {
    minX -= marginM;
    minY -= marginM;
    minZ -= marginM;
    maxX += marginM;
    maxY += marginM;
    maxZ += marginM;
  }

  /** Returns true if the ray, at its present length, meets this box. */
  public boolean isReachedBy(Ray ray) {
    double a = (minX - ray.originX()) * ray.inverseX();
    double b = (maxX - ray.originX()) * ray.inverseX();
    double enter = greater(0, lesser(a, b));
    double exit = lesser(ray.lengthM(), greater(a, b));
    a = (minZ - ray.originZ()) * ray.inverseZ();
    b = (maxZ - ray.originZ()) * ray.inverseZ();
    enter = greater(enter, lesser(a, b));
    exit = lesser(exit, greater(a, b));
    if (enter > exit) {
      return false;
    }
    a = (minY - ray.originY()) * ray.inverseY();
    b = (maxY - ray.originY()) * ray.inverseY();
    return greater(enter, lesser(a, b)) <= lesser(exit, greater(a, b));
  }

  /** Several times as fast as Math.min, which also orders NaN and the two zeros. */
  private static double lesser(double a, double b) {
    return a < b ? a : b;
  }

  private static double greater(double a, double b) {
    return a > b ? a : b;
  }

  /** Returns true if a ball, its rim included, shares a point with this box. */
  public boolean touchesBall(double xM, double yM, double zM, double radiusM) {
    double dx = gap(xM, minX, maxX);
    double dy = gap(yM, minY, maxY);
    double dz = gap(zM, minZ, maxZ);
    return dx * dx + dy * dy + dz * dz <= radiusM * radiusM;
  }

  private static double gap(double at, double min, double max) {
    return greater(0, greater(min - at, at - max));
  }

  /** Returns half the surface in square metres, a measure of how likely a ray meets this box. */
  public double halfSurfaceM2() {
    double x = maxX - minX;
    double y = maxY - minY;
    double z = maxZ - minZ;
    return x * y + y * z + z * x;
  }

  /** Returns the least x in metres; positive infinity if empty. */
  public double minX() {
    return minX;
  }

  /** Returns the least y in metres; positive infinity if empty. */
  public double minY() {
    return minY;
  }

  /** Returns the least z in metres; positive infinity if empty. */
  public double minZ() {
    return minZ;
  }

  /** Returns the greatest x in metres; negative infinity if empty. */
  public double maxX() {
    return maxX;
  }

  /** Returns the greatest y in metres; negative infinity if empty. */
  public double maxY() {
    return maxY;
  }

  /** Returns the greatest z in metres; negative infinity if empty. */
  public double maxZ() {
    return maxZ;
  }
}
