package simbad.studio;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.shape.Outline;

/** Where Simbad's own sensor hears an obstacle at most: so far from its nearest point. */
final class OriginalEdge {
  private static final int POINTS = 180;
  private static final int HALVINGS = 50;

  private OriginalEdge() {}

  /**
   * Returns places all round that are {@value DetectionRule#ORIGINAL_RANGE_M} m from the nearest
   * point of the outline; on each bearing the furthest one.
   *
   * @param outline in its own frame
   */
  static List<Point> of(Outline outline) {
    List<Point> edge = new ArrayList<>(POINTS);
    for (int i = 0; i < POINTS; i++) {
      double bearing = Angles.TURN_RAD * i / POINTS;
      edge.add(on(outline, Math.sin(bearing), Math.cos(bearing)));
    }
    return edge;
  }

  private static Point on(Outline outline, double directionX, double directionZ) {
    double low = 0;
    double high = DetectionRule.ORIGINAL_RANGE_M + outline.reachM(0, 0);
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2;
      double toOutlineM = outline.distanceM(middle * directionX, middle * directionZ);
      if (toOutlineM <= DetectionRule.ORIGINAL_RANGE_M) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return new Point(low * directionX, low * directionZ);
  }
}
