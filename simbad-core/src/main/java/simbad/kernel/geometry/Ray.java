package simbad.kernel.geometry;

/**
 * A ray of limited length that shortens itself to whatever it meets: cast it against any number of
 * shapes in any order and what remains is the distance to the nearest surface.
 *
 * <p>A mutable buffer; not safe for use by several threads.
 */
public final class Ray {
  /** Stands for 1/0: finite, so that 0 times it stays 0 where infinity would give NaN. */
  private static final double STEEP = 1e300;

  private double originX;
  private double originY;
  private double originZ;
  private double directionX;
  private double directionY;
  private double directionZ;
  private double inverseX;
  private double inverseY;
  private double inverseZ;
  private boolean inverted;
  private double lengthM;

  /** Creates a ray of no length at the origin. */
  public Ray() {}

  /** Lets the ray start at a point in metres. */
  public void setOrigin(double xM, double yM, double zM) {
    originX = xM;
    originY = yM;
    originZ = zM;
  }

  /** Points the ray along a direction of length 1. */
  public void setDirection(double x, double y, double z) {
    directionX = x;
    directionY = y;
    directionZ = z;
    inverted = false;
  }

  /** Divides late: most rays are turned away from most bodies before that. */
  private void invert() {
    if (!inverted) {
      inverted = true;
      inverseX = inverse(directionX);
      inverseY = inverse(directionY);
      inverseZ = inverse(directionZ);
    }
  }

  private static double inverse(double component) {
    return component == 0 ? STEEP : 1 / component;
  }

  /**
   * Gives the ray its full length.
   *
   * @param newLengthM metres; at least 0
   */
  public void setLength(double newLengthM) {
    if (!(newLengthM >= 0)) {
      throw new IllegalArgumentException("lengthM = " + newLengthM + " is not in [0, infinity)");
    }
    lengthM = newLengthM;
  }

  /**
   * Shortens the ray if a surface lies within it.
   *
   * @param distanceM distance of a surface from the origin along the ray, metres
   * @return true if the distance is in [0, length]
   */
  public boolean shortenTo(double distanceM) {
    if (distanceM >= 0 && distanceM <= lengthM) {
      lengthM = distanceM;
      return true;
    }
    return false;
  }

  /** Becomes the image of a ray of the outer frame in a body's frame; lengths agree. */
  public void setToLocal(Ray outer, Placement outerFromLocal) {
    Placement frame = outerFromLocal;
    double x = outer.originX - frame.xM();
    double y = outer.originY - frame.yM();
    double z = outer.originZ - frame.zM();
    setOrigin(frame.innerX(x, y, z), frame.innerY(x, y, z), frame.innerZ(x, y, z));
    x = outer.directionX;
    y = outer.directionY;
    z = outer.directionZ;
    setDirection(frame.innerX(x, y, z), frame.innerY(x, y, z), frame.innerZ(x, y, z));
    lengthM = outer.lengthM;
  }

  /** Returns the x coordinate of the origin in metres. */
  public double originX() {
    return originX;
  }

  /** Returns the height of the origin in metres. */
  public double originY() {
    return originY;
  }

  /** Returns the z coordinate of the origin in metres. */
  public double originZ() {
    return originZ;
  }

  /** Returns the x component of the direction. */
  public double directionX() {
    return directionX;
  }

  /** Returns the y component of the direction. */
  public double directionY() {
    return directionY;
  }

  /** Returns the z component of the direction. */
  public double directionZ() {
    return directionZ;
  }

  /** Returns the length that is left, in metres. */
  public double lengthM() {
    return lengthM;
  }

  double inverseX() {
    invert();
    return inverseX;
  }

  double inverseY() {
    invert();
    return inverseY;
  }

  double inverseZ() {
    invert();
    return inverseZ;
  }
}
