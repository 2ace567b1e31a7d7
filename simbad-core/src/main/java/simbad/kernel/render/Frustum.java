package simbad.kernel.render;

/**
 * What of the space before an eye is drawn, as planes: one before the eye, and four through the eye
 * that stand {@value #GUARD} times as far out as the picture's edges. Beyond the edges nothing is
 * drawn anyway; the planes keep pixel coordinates within bounds and are seldom met.
 */
final class Frustum {
  static final int PLANES = 5;

  /** The plane that holds everything that is too near. */
  static final int NEAR = 0;

  private static final double GUARD = 4;

  private double slopeRight;
  private double slopeUp;

  /** Fits to a picture. */
  void fit(Picture picture) {
    slopeRight = Math.tan(PictureSource.FIELD_OF_VIEW_RAD / 2);
    slopeUp = slopeRight * picture.height() / picture.width();
  }

  /** Returns pixels per metre at depth 1 m. */
  double focalPx(Picture picture) {
    return picture.width() / 2.0 / slopeRight;
  }

  /** Returns how far inside a plane a point is, in some unit of that plane. */
  double inside(int plane, double depthM, double rightM, double upM) {
    return switch (plane) {
      case NEAR -> depthM - PictureSource.NEAR_M;
      case 1 -> GUARD * slopeRight * depthM - rightM;
      case 2 -> GUARD * slopeRight * depthM + rightM;
      case 3 -> GUARD * slopeUp * depthM - upM;
      default -> GUARD * slopeUp * depthM + upM;
    };
  }

  /** Returns false if nothing of a ball can be in the picture. */
  boolean mayShow(double depthM, double rightM, double upM, double radiusM) {
    return depthM + radiusM > PictureSource.NEAR_M
        && isWithin(depthM, rightM, slopeRight, radiusM)
        && isWithin(depthM, upM, slopeUp, radiusM);
  }

  /** Compares the ball's distance from the plane through the picture's edge with its radius. */
  private static boolean isWithin(double depthM, double asideM, double slope, double radiusM) {
    double outside = Math.abs(asideM) - slope * depthM;
    return outside <= radiusM * Math.sqrt(1 + slope * slope);
  }
}
