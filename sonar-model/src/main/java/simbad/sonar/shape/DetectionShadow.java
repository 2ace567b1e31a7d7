package simbad.sonar.shape;

import java.util.List;
import java.util.Optional;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;

/**
 * The region round an obstacle in which a sensor hears it: the upright prism over the polygon of a
 * threshold table's points, in the obstacle's own frame, standing on the floor.
 *
 * <p>Kranz (2014), section 4.2.3 and appendix A.2. Immutable.
 */
public final class DetectionShadow {
  private static final int VERTICES_PER_CELL = 12;
  private static final int COORDINATES = 3;

  /** Bottom, top, and the two halves of the wall: which vertices of a cell lie at the top. */
  private static final boolean[] AT_TOP = {
    false, false, false, true, true, true, false, false, true, false, true, true
  };

  private final ThresholdTable table;
  private final List<Point> points;

  /**
   * Creates the shadow of a table.
   *
   * @param table by bearing in the obstacle's own frame
   */
  public DetectionShadow(ThresholdTable table) {
    this.table = table;
    points = table.points();
  }

  /** Returns the table that the shadow is made of. */
  public ThresholdTable table() {
    return table;
  }

  /**
   * Returns the shadow's edge on the plane; none when every threshold is 0, for then there is no
   * shadow.
   */
  public Optional<Outline> edge() {
    return table.greatestM() > 0 ? Optional.of(Outline.of(points)) : Optional.empty();
  }

  /**
   * Tells whether a place lies in the shadow, its edge included. Where the threshold is 0 nothing
   * does, the centre neither.
   *
   * @param own in the obstacle's own frame
   */
  public boolean contains(Point own) {
    double threshold = table.thresholdM(Angles.positive(Math.atan2(own.xM(), own.zM())));
    return threshold > 0 && Math.hypot(own.xM(), own.zM()) <= threshold;
  }

  /**
   * Returns the mesh's triangles: per cell of the table one at the bottom, one at the top and two
   * of the wall.
   *
   * @param heightM of the prism, metres, positive
   * @return x, y, z of one vertex after another, three vertices a triangle; y is 0 or the height
   */
  public double[] triangles(double heightM) {
    if (!(heightM > 0 && heightM < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("heightM = " + heightM + " is not in (0, infinity)");
    }
    double[] out = new double[points.size() * VERTICES_PER_CELL * COORDINATES];
    Point centre = new Point(0, 0);
    int at = 0;
    for (int i = 0; i < points.size(); i++) {
      Point a = points.get(i);
      Point b = points.get((i + 1) % points.size());
      Point[] corners = {centre, a, b, centre, a, b, a, b, a, b, b, a};
      for (int v = 0; v < VERTICES_PER_CELL; v++) {
        out[at++] = corners[v].xM();
        out[at++] = AT_TOP[v] ? heightM : 0;
        out[at++] = corners[v].zM();
      }
    }
    return out;
  }
}
