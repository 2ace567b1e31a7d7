package simbad.sonar.format;

import java.util.List;
import simbad.sonar.check.Checks;

/**
 * How a sensor's sensitivity falls off its axis.
 *
 * @param source where the figures come from
 * @param points at rising angles, the first on the axis
 */
public record Sensitivity(String source, List<Point> points) {
  /**
   * One angle.
   *
   * @param offAxisDeg degrees off the axis, in [0, 180]
   * @param levelDb one way, 0 on the axis, not above
   */
  public record Point(double offAxisDeg, double levelDb) {
    /** Refuses what is no number. */
    public Point {
      Checks.finite("offAxisDeg", offAxisDeg);
      Checks.finite("levelDb", levelDb);
    }
  }

  /** Copies the list and checks the angles' order. */
  public Sensitivity {
    points = List.copyOf(points);
    for (int i = 0; i < points.size(); i++) {
      double before = i == 0 ? -1 : points.get(i - 1).offAxisDeg();
      if (!(points.get(i).offAxisDeg() > before)) {
        throw new IllegalArgumentException(
            "angle " + points.get(i).offAxisDeg() + " does not rise from " + before);
      }
    }
  }
}
