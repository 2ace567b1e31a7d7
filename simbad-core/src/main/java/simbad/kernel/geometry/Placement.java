package simbad.kernel.geometry;

import simbad.sonar.check.Checks;

/**
 * Where a body is and how it is turned: a rigid motion from the body's own frame to the frame in
 * which it is placed. Mutable; not safe for use by several threads.
 */
public final class Placement {
  private double xM;
  private double yM;
  private double zM;
  private double m00 = 1;
  private double m01;
  private double m02;
  private double m10;
  private double m11 = 1;
  private double m12;
  private double m20;
  private double m21;
  private double m22 = 1;

  /** Creates the identity: at the origin, not turned. */
  public Placement() {}

  /** Creates a placement at a point in metres, not turned. */
  public static Placement at(double xM, double yM, double zM) {
    Checks.finite("xM", xM);
    Checks.finite("yM", yM);
    Checks.finite("zM", zM);
    Placement placement = new Placement();
    placement.moveTo(xM, yM, zM);
    return placement;
  }

  /** Moves to a point in metres; the rotation stays. */
  public void moveTo(double newXM, double newYM, double newZM) {
    xM = newXM;
    yM = newYM;
    zM = newZM;
  }

  /** Moves by a displacement in metres, given in the outer frame. */
  public void moveBy(double dxM, double dyM, double dzM) {
    xM += dxM;
    yM += dyM;
    zM += dzM;
  }

  /** Forgets every turn; the position stays. */
  public void resetTurn() {
    m00 = 1;
    m01 = 0;
    m02 = 0;
    m10 = 0;
    m11 = 1;
    m12 = 0;
    m20 = 0;
    m21 = 0;
    m22 = 1;
  }

  /** Turns about the body's own vertical axis, counter-clockwise as seen from above. */
  public void turnAboutY(double angleRad) {
    if (angleRad != 0) {
      turnAboutY(Math.cos(angleRad), Math.sin(angleRad));
    }
  }

  /** Turns by quarter turns about the body's own vertical axis, without rounding. */
  public void turnQuarters(int quarters) {
    switch (Math.floorMod(quarters, 4)) {
      case 1 -> turnAboutY(0, 1);
      case 2 -> turnAboutY(-1, 0);
      case 3 -> turnAboutY(0, -1);
      default -> turnAboutY(1, 0);
    }
  }

  private void turnAboutY(double cos, double sin) {
    double a = m00;
    double b = m10;
    double c = m20;
    m00 = a * cos - m02 * sin;
    m02 = a * sin + m02 * cos;
    m10 = b * cos - m12 * sin;
    m12 = b * sin + m12 * cos;
    m20 = c * cos - m22 * sin;
    m22 = c * sin + m22 * cos;
  }

  /** Turns about the body's own z axis, from its x axis towards its y axis. */
  public void turnAboutZ(double angleRad) {
    double cos = Math.cos(angleRad);
    double sin = Math.sin(angleRad);
    double a = m00;
    double b = m10;
    double c = m20;
    m00 = a * cos + m01 * sin;
    m01 = m01 * cos - a * sin;
    m10 = b * cos + m11 * sin;
    m11 = m11 * cos - b * sin;
    m20 = c * cos + m21 * sin;
    m21 = m21 * cos - c * sin;
  }

  /** Becomes a copy of another placement. */
  public void copyFrom(Placement other) {
    moveTo(other.xM, other.yM, other.zM);
    m00 = other.m00;
    m01 = other.m01;
    m02 = other.m02;
    m10 = other.m10;
    m11 = other.m11;
    m12 = other.m12;
    m20 = other.m20;
    m21 = other.m21;
    m22 = other.m22;
  }

  /**
   * Becomes the placement of a part whose place in a body is known.
   *
   * @param worldFromBody where the body is; may not be this object
   * @param bodyFromPart where the part is in the body; may not be this object
   */
  public void compose(Placement worldFromBody, Placement bodyFromPart) {
    Placement a = worldFromBody;
    Placement b = bodyFromPart;
    moveTo(a.outerX(b.xM, b.yM, b.zM), a.outerY(b.xM, b.yM, b.zM), a.outerZ(b.xM, b.yM, b.zM));
    m00 = a.turnedX(b.m00, b.m10, b.m20);
    m10 = a.turnedY(b.m00, b.m10, b.m20);
    m20 = a.turnedZ(b.m00, b.m10, b.m20);
    m01 = a.turnedX(b.m01, b.m11, b.m21);
    m11 = a.turnedY(b.m01, b.m11, b.m21);
    m21 = a.turnedZ(b.m01, b.m11, b.m21);
    m02 = a.turnedX(b.m02, b.m12, b.m22);
    m12 = a.turnedY(b.m02, b.m12, b.m22);
    m22 = a.turnedZ(b.m02, b.m12, b.m22);
  }

  /**
   * Becomes the way back: from the frame in which a body is placed to the body's own.
   *
   * @param worldFromBody where the body is; may not be this object
   */
  public void invert(Placement worldFromBody) {
    Placement a = worldFromBody;
    m00 = a.m00;
    m01 = a.m10;
    m02 = a.m20;
    m10 = a.m01;
    m11 = a.m11;
    m12 = a.m21;
    m20 = a.m02;
    m21 = a.m12;
    m22 = a.m22;
    moveTo(-turnedX(a.xM, a.yM, a.zM), -turnedY(a.xM, a.yM, a.zM), -turnedZ(a.xM, a.yM, a.zM));
  }

  /** Returns the x coordinate of the body's origin in metres. */
  public double xM() {
    return xM;
  }

  /** Returns the height of the body's origin in metres. */
  public double yM() {
    return yM;
  }

  /** Returns the z coordinate of the body's origin in metres. */
  public double zM() {
    return zM;
  }

  /** Returns the heading of the body's x axis in radians, in [-pi, pi]; tilt is left out. */
  public double headingRad() {
    return Math.atan2(m02, m00);
  }

  /** Returns an element of the rotation matrix, rows and columns from 0. */
  public double rotation(int row, int column) {
    return switch (row * 3 + column) {
      case 0 -> m00;
      case 1 -> m01;
      case 2 -> m02;
      case 3 -> m10;
      case 4 -> m11;
      case 5 -> m12;
      case 6 -> m20;
      case 7 -> m21;
      case 8 -> m22;
      default -> throw new IllegalArgumentException("element " + row + ", " + column);
    };
  }

  /** Writes the rotation into a homogeneous 4 by 4 matrix, row after row; nothing else of it. */
  public void copyRotationTo(double[] matrix) {
    matrix[0] = m00;
    matrix[1] = m01;
    matrix[2] = m02;
    matrix[4] = m10;
    matrix[5] = m11;
    matrix[6] = m12;
    matrix[8] = m20;
    matrix[9] = m21;
    matrix[10] = m22;
  }

  /** Returns the outer x of a point given in the body's frame. */
  public double outerX(double x, double y, double z) {
    return xM + turnedX(x, y, z);
  }

  /** Returns the outer y of a point given in the body's frame. */
  public double outerY(double x, double y, double z) {
    return yM + turnedY(x, y, z);
  }

  /** Returns the outer z of a point given in the body's frame. */
  public double outerZ(double x, double y, double z) {
    return zM + turnedZ(x, y, z);
  }

  /** Returns the outer x of a direction given in the body's frame. */
  public double turnedX(double x, double y, double z) {
    return m00 * x + m01 * y + m02 * z;
  }

  /** Returns the outer y of a direction given in the body's frame. */
  public double turnedY(double x, double y, double z) {
    return m10 * x + m11 * y + m12 * z;
  }

  /** Returns the outer z of a direction given in the body's frame. */
  public double turnedZ(double x, double y, double z) {
    return m20 * x + m21 * y + m22 * z;
  }

  /** Returns the body-frame x of a direction given in the outer frame. */
  double innerX(double x, double y, double z) {
    return m00 * x + m10 * y + m20 * z;
  }

  /** Returns the body-frame y of a direction given in the outer frame. */
  double innerY(double x, double y, double z) {
    return m01 * x + m11 * y + m21 * z;
  }

  /** Returns the body-frame z of a direction given in the outer frame. */
  double innerZ(double x, double y, double z) {
    return m02 * x + m12 * y + m22 * z;
  }

  /** Returns true if the vertical axis is still vertical. */
  public boolean isUpright() {
    return m11 == 1 && m10 == 0 && m12 == 0 && m01 == 0 && m21 == 0;
  }

  @Override
  public String toString() {
    return "(" + xM + ", " + yM + ", " + zM + "; heading " + headingRad() + ")";
  }
}
