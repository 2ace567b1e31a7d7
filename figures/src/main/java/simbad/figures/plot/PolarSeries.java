package simbad.figures.plot;

import java.util.List;

/**
 * A curve or a cloud of points round an obstacle.
 *
 * @param name what the legend says; not blank, as long as need be
 * @param role what the series stands for, which fixes its looks
 * @param style how the points are joined
 * @param pattern 0 for the role's own dash, or {@link #SECOND}
 * @param points in order; may be empty, which the legend then says
 */
public record PolarSeries(
    String name, SeriesRole role, SeriesStyle style, int pattern, List<PolarPoint> points) {
  /** A dash that no role has by itself, for a second series of one role. */
  public static final int SECOND = 6;

  /** Copies the list. */
  public PolarSeries {
    Labels.notBlank("name", name);
    points = List.copyOf(points);
  }

  /** Creates a series with its role's own dash. */
  public PolarSeries(String name, SeriesRole role, SeriesStyle style, List<PolarPoint> points) {
    this(name, role, style, 0, points);
  }

  double largestRadiusM() {
    return points.stream().mapToDouble(PolarPoint::radiusM).max().orElse(0);
  }
}
