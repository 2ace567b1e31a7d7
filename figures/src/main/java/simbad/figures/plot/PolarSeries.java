package simbad.figures.plot;

import java.util.List;

/**
 * A curve or a cloud of points round an obstacle.
 *
 * @param name what the legend says; not blank, as long as need be
 * @param role what the series stands for, which fixes its looks
 * @param style how the points are joined
 * @param points in order; may be empty, which the legend then says
 */
public record PolarSeries(
    String name, SeriesRole role, SeriesStyle style, List<PolarPoint> points) {
  /** Copies the list. */
  public PolarSeries {
    Labels.notBlank("name", name);
    points = List.copyOf(points);
  }

  double largestRadiusM() {
    return points.stream().mapToDouble(PolarPoint::radiusM).max().orElse(0);
  }
}
