package simbad.sonar.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;

/**
 * The boundary of a cross-section: a closed polygon, the last corner joined to the first.
 *
 * <p>Either sense of going round is accepted. What answers a ping is this line, not the area in it.
 * Immutable.
 */
public final class Outline {
  private final double[] xM;
  private final double[] zM;
  private final double longestEdgeM;

  private Outline(double[] xM, double[] zM) {
    this.xM = xM;
    this.zM = zM;
    double longest = 0;
    for (int i = 0, j = xM.length - 1; i < xM.length; j = i++) {
      longest = Math.max(longest, Math.hypot(xM[i] - xM[j], zM[i] - zM[j]));
    }
    longestEdgeM = longest;
  }

  /**
   * Creates an outline.
   *
   * @param corners at least 3, not all at one place
   * @throws IllegalArgumentException if there are fewer, or all coincide
   */
  public static Outline of(List<Point> corners) {
    if (corners.size() < 3) {
      throw new IllegalArgumentException(
          "corners = " + corners.size() + " points; an outline has at least 3");
    }
    Point first = corners.get(0);
    if (corners.stream().allMatch(first::equals)) {
      throw new IllegalArgumentException("corners all lie at " + first);
    }
    return new Outline(
        corners.stream().mapToDouble(Point::xM).toArray(),
        corners.stream().mapToDouble(Point::zM).toArray());
  }

  /**
   * Joins outlines by a line of no width from the first one's first corner to each other one's, to
   * and fro.
   *
   * @param parts at least one, which do not overlap
   */
  public static Outline joined(List<Outline> parts) {
    if (parts.size() == 1) {
      return parts.get(0);
    }
    List<Point> corners = new ArrayList<>();
    for (Outline part : parts) {
      corners.addAll(part.corners());
      corners.add(part.corners().get(0));
      corners.add(parts.get(0).corners().get(0));
    }
    return of(corners);
  }

  /** Returns the number of corners, which is the number of edges too. */
  public int size() {
    return xM.length;
  }

  /**
   * Returns the x coordinate of a corner in metres.
   *
   * @param corner index, from 0
   */
  public double xM(int corner) {
    return xM[corner];
  }

  /**
   * Returns the z coordinate of a corner in metres.
   *
   * @param corner index, from 0
   */
  public double zM(int corner) {
    return zM[corner];
  }

  /** Returns the corners as points. */
  public List<Point> corners() {
    List<Point> corners = new ArrayList<>(size());
    for (int i = 0; i < size(); i++) {
      corners.add(new Point(xM[i], zM[i]));
    }
    return List.copyOf(corners);
  }

  /** Returns the same outline in the world, given one in an obstacle's own frame. */
  public Outline placed(Placement worldFromObstacle) {
    return of(corners().stream().map(worldFromObstacle::worldFromObstacle).toList());
  }

  /** Returns the length of the longest edge in metres. */
  public double longestEdgeM() {
    return longestEdgeM;
  }

  /**
   * Returns the greatest distance of the outline from a point in metres.
   *
   * @param fromXM metres
   * @param fromZM metres
   */
  public double reachM(double fromXM, double fromZM) {
    double reach = 0;
    for (int i = 0; i < size(); i++) {
      reach = Math.max(reach, Math.hypot(xM[i] - fromXM, zM[i] - fromZM));
    }
    return reach;
  }

  /**
   * Returns the distance from a place to the nearest point of the outline in metres; inside the
   * cross-section too.
   *
   * @param fromXM metres
   * @param fromZM metres
   */
  public double distanceM(double fromXM, double fromZM) {
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0, j = size() - 1; i < size(); j = i++) {
      best = Math.min(best, edgeDistance2(j, i, fromXM, fromZM));
    }
    return Math.sqrt(best);
  }

  /**
   * Finds the nearest point of the outline, or two that are equally near.
   *
   * @param fromXM metres
   * @param fromZM metres
   * @param found is filled anew
   */
  public void findNearest(double fromXM, double fromZM, NearestPoints found) {
    found.clear();
    for (int i = 0, j = size() - 1; i < size(); j = i++) {
      double share = footShare(j, i, fromXM, fromZM);
      double x = xM[j] + share * (xM[i] - xM[j]);
      double z = zM[j] + share * (zM[i] - zM[j]);
      double dx = x - fromXM;
      double dz = z - fromZM;
      found.offer(x, z, Math.sqrt(dx * dx + dz * dz));
    }
  }

  /** Square of the distance from an edge. */
  private double edgeDistance2(int from, int to, double px, double pz) {
    double t = footShare(from, to, px, pz);
    double beyondX = px - xM[from] - t * (xM[to] - xM[from]);
    double beyondZ = pz - zM[from] - t * (zM[to] - zM[from]);
    return beyondX * beyondX + beyondZ * beyondZ;
  }

  /** Where along an edge its nearest point lies, in [0, 1]. */
  private double footShare(int from, int to, double px, double pz) {
    double ex = xM[to] - xM[from];
    double ez = zM[to] - zM[from];
    double along = (px - xM[from]) * ex + (pz - zM[from]) * ez;
    double length2 = ex * ex + ez * ez;
    return along <= 0 ? 0 : along >= length2 ? 1 : along / length2;
  }

  /**
   * Returns the area within in square metres: positive when the corners go round counter-clockwise
   * as seen from above (x to the right, z down the page), negative when clockwise.
   */
  public double signedAreaM2() {
    double twice = 0;
    for (int i = 0, j = size() - 1; i < size(); j = i++) {
      twice += xM[i] * zM[j] - xM[j] * zM[i];
    }
    return twice / 2;
  }

  /** Returns the length of the closed line in metres. */
  public double perimeterM() {
    double length = 0;
    for (int i = 0, j = size() - 1; i < size(); j = i++) {
      length += Math.hypot(xM[i] - xM[j], zM[i] - zM[j]);
    }
    return length;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Outline that
        && Arrays.equals(xM, that.xM)
        && Arrays.equals(zM, that.zM);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(xM) + Arrays.hashCode(zM);
  }

  @Override
  public String toString() {
    return "Outline" + corners();
  }
}
