package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** What the sensors of the logs looked at, seen from above, heard from everywhere. */
final class Shapes {
  private static final int CORNERS = 24;
  private static final double THICKNESS_M = 0.02;

  private Shapes() {}

  /** A board across the z axis whose face to +z lies at z. */
  static Obstacle board(String name, double zM, double widthM, double heardM) {
    double half = widthM / 2;
    Outline outline =
        Outline.of(
            List.of(
                new Point(-half, 0),
                new Point(half, 0),
                new Point(half, -THICKNESS_M),
                new Point(-half, -THICKNESS_M)));
    return new Obstacle(name, new Placement(0, zM, 0), outline, new UniformDetection(heardM));
  }

  /** A ball at the origin. */
  static Obstacle ball(String name, double radiusM, double heardM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < CORNERS; i++) {
      double angle = i * Angles.TURN_RAD / CORNERS;
      corners.add(new Point(radiusM * Math.cos(angle), radiusM * Math.sin(angle)));
    }
    return new Obstacle(
        name, new Placement(0, 0, 0), Outline.of(corners), new UniformDetection(heardM));
  }
}
