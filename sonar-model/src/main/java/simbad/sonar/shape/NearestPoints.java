package simbad.sonar.shape;

/**
 * Which point of an outline is nearest to a place, or two that are equally near: before a symmetric
 * body that is open in front there are two, and which one counts must not depend on the order of
 * the corners. A buffer that is filled anew, so that sensing allocates nothing.
 */
public final class NearestPoints {
  /** As a share of the distance: what differs by less is rounding. */
  private static final double ROUNDING = 1e-9;

  private double distanceM = Double.POSITIVE_INFINITY;
  private double xM;
  private double zM;
  private double otherXM;
  private double otherZM;

  /** Creates a buffer that knows of no point. */
  public NearestPoints() {}

  /** Forgets all points. */
  void clear() {
    distanceM = Double.POSITIVE_INFINITY;
  }

  /** Takes a point if none is nearer. */
  void offer(double atXM, double atZM, double atDistanceM) {
    double slack = ROUNDING * atDistanceM;
    if (atDistanceM < distanceM - slack) {
      distanceM = atDistanceM;
      xM = atXM;
      zM = atZM;
      otherXM = atXM;
      otherZM = atZM;
    } else if (atDistanceM <= distanceM + slack
        && Math.abs(atXM - xM) + Math.abs(atZM - zM) > slack) {
      otherXM = atXM;
      otherZM = atZM;
    }
  }

  /** Returns the distance in metres; infinity while no point is known. */
  public double distanceM() {
    return distanceM;
  }

  /** Returns where a nearest point is, metres. */
  public double xM() {
    return xM;
  }

  /** Returns where a nearest point is, metres. */
  public double zM() {
    return zM;
  }

  /** Returns where the other nearest point is, metres; the same again when there is one only. */
  public double otherXM() {
    return otherXM;
  }

  /** Returns where the other nearest point is, metres. */
  public double otherZM() {
    return otherZM;
  }
}
