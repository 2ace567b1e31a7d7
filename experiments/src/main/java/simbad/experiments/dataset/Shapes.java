package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** What the sensors of the logs looked at, seen from above. */
final class Shapes {
  private static final int CORNERS = 24;
  private static final double THICKNESS_M = 0.02;

  private Shapes() {}

  /** A board across the z axis, 2 cm thick, whose face to +z lies at z = 0. */
  static Outline board(double widthM) {
    double half = widthM / 2;
    return Outline.of(
        List.of(
            new Point(-half, 0),
            new Point(half, 0),
            new Point(half, -THICKNESS_M),
            new Point(-half, -THICKNESS_M)));
  }

  /** A round section about the origin, as a polygon whose corners lie on it. */
  static Outline round(double radiusM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < CORNERS; i++) {
      double angle = i * Angles.TURN_RAD / CORNERS;
      corners.add(new Point(radiusM * Math.cos(angle), radiusM * Math.sin(angle)));
    }
    return Outline.of(corners);
  }

  /** A square about the origin, its sides along the axes. */
  static Outline square(double sideM) {
    double half = sideM / 2;
    return Outline.of(
        List.of(
            new Point(-half, -half),
            new Point(half, -half),
            new Point(half, half),
            new Point(-half, half)));
  }

  /** A board whose face to +z lies at z, heard from everywhere. */
  static Obstacle board(String name, double zM, double widthM, double heardM) {
    return new Obstacle(name, new Placement(0, zM, 0), board(widthM), new UniformDetection(heardM));
  }

  /** A ball at the origin, heard from everywhere. */
  static Obstacle ball(String name, double radiusM, double heardM) {
    return new Obstacle(name, Placement.IDENTITY, round(radiusM), new UniformDetection(heardM));
  }

  /**
   * Returns how far from the centre the outline lies on the +z axis; where none of it does, how far
   * it reaches along z.
   */
  static double frontM(Outline outline) {
    double on = Double.NEGATIVE_INFINITY;
    double reach = Double.NEGATIVE_INFINITY;
    for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      reach = Math.max(reach, outline.zM(i));
      double from = outline.xM(j);
      double to = outline.xM(i);
      if (Math.min(from, to) <= 0 && Math.max(from, to) >= 0) {
        double share = from == to ? 1 : from / (from - to);
        double z = outline.zM(j) + share * (outline.zM(i) - outline.zM(j));
        on = Math.max(on, from == to ? Math.max(outline.zM(i), outline.zM(j)) : z);
      }
    }
    return Double.isFinite(on) ? on : reach;
  }
}
