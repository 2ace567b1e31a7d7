package simbad.sonar.shape;

/** How far two cross-sections lie over each other. */
public final class Overlap {
  /** Less than this is rounding, as where turned bodies touch; a square of 0.03 mm. */
  private static final double LEAST_M2 = 1e-9;

  private Overlap() {}

  /**
   * Tells whether two outlines in one frame cross each other or one holds the other; those that
   * touch do not overlap.
   *
   * @param one closed polygon that does not cross itself, in either sense
   * @param other another
   */
  public static boolean of(Outline one, Outline other) {
    return areaM2(one, other) > LEAST_M2;
  }

  /**
   * Returns the area that two outlines share in square metres.
   *
   * <p>A polygon is the signed sum of the strips between its edges and one line below all of them,
   * so that what two polygons share is the sum over all pairs of strips; no edge that touches or
   * lies along another needs a case of its own.
   *
   * @param one closed polygon that does not cross itself, in either sense
   * @param other another
   */
  public static double areaM2(Outline one, Outline other) {
    double floor = Math.min(leastZM(one), leastZM(other));
    double sum = 0;
    for (int i = 0; i < one.size(); i++) {
      for (int j = 0; j < other.size(); j++) {
        sum += sharedStripM2(one, i, other, j, floor);
      }
    }
    return sum * Math.signum(one.signedAreaM2()) * Math.signum(other.signedAreaM2());
  }

  private static double leastZM(Outline outline) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < outline.size(); i++) {
      least = Math.min(least, outline.zM(i));
    }
    return least;
  }

  /** Negative where the two edges run in opposite senses. */
  private static double sharedStripM2(Outline a, int i, Outline b, int j, double floor) {
    int i2 = (i + 1) % a.size();
    int j2 = (j + 1) % b.size();
    double left = Math.max(Math.min(a.xM(i), a.xM(i2)), Math.min(b.xM(j), b.xM(j2)));
    double right = Math.min(Math.max(a.xM(i), a.xM(i2)), Math.max(b.xM(j), b.xM(j2)));
    if (left >= right) {
      return 0;
    }
    double sense = Math.signum(a.xM(i2) - a.xM(i)) * Math.signum(b.xM(j2) - b.xM(j));
    double aLeft = heightM(a, i, i2, left) - floor;
    double aRight = heightM(a, i, i2, right) - floor;
    double bLeft = heightM(b, j, j2, left) - floor;
    double bRight = heightM(b, j, j2, right) - floor;
    return sense * (right - left) * meanOfLower(aLeft, aRight, bLeft, bRight);
  }

  private static double heightM(Outline outline, int from, int to, double x) {
    double share = (x - outline.xM(from)) / (outline.xM(to) - outline.xM(from));
    return outline.zM(from) + share * (outline.zM(to) - outline.zM(from));
  }

  /** Mean of the lower of two straight lines over an interval, given both at its ends. */
  private static double meanOfLower(double aLeft, double aRight, double bLeft, double bRight) {
    double left = aLeft - bLeft;
    double right = aRight - bRight;
    double lower = (Math.min(aLeft, bLeft) + Math.min(aRight, bRight)) / 2;
    if (left * right >= 0) {
      return lower;
    }
    // They cross: the chord between the lower ends runs under the roof that the two make.
    double roof = Math.abs(left * right) / (2 * (Math.abs(left) + Math.abs(right)));
    return lower + roof;
  }
}
