package simbad.kernel.scene;

/** A region round a point of the world. A mutable buffer; not safe for use by several threads. */
public final class Ball {
  private double xM;
  private double yM;
  private double zM;
  private double radiusM;

  /** Creates a ball without extent at the origin. */
  public Ball() {}

  /** Sets the centre and the radius, metres. */
  public void set(double newXM, double newYM, double newZM, double newRadiusM) {
    xM = newXM;
    yM = newYM;
    zM = newZM;
    radiusM = newRadiusM;
  }

  /** Returns true if all of another ball is inside this one; rounding may say no for yes. */
  boolean holds(Ball other) {
    double x = other.xM - xM;
    double y = other.yM - yM;
    double z = other.zM - zM;
    double roomM = radiusM - other.radiusM;
    return roomM >= 0 && x * x + y * y + z * z <= roomM * roomM;
  }

  /** Returns the x of the centre in metres. */
  public double xM() {
    return xM;
  }

  /** Returns the height of the centre in metres. */
  public double yM() {
    return yM;
  }

  /** Returns the z of the centre in metres. */
  public double zM() {
    return zM;
  }

  /** Returns the radius in metres. */
  public double radiusM() {
    return radiusM;
  }
}
