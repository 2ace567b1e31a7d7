package simbad.figures.plot;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import simbad.figures.markup.Corners;

/**
 * Leaves points out of long curves without a visible change (Douglas and Peucker, Cartographica
 * 10(2), 1973).
 *
 * <p>A curve of at most {@link #UNTOUCHED} points is kept as it is, corners on straight edges
 * included. A longer one deviates from what was given by at most 0.5 mm, or 1/6000 of the picture's
 * half width where that is more (a thirtieth of a printed point); only if that leaves too many
 * points for the picture's budget is the tolerance doubled until it does not. Of a cloud of dots,
 * one in each cell as wide as that tolerance is kept.
 */
final class Thinning {
  /** Curves this short are drawn point by point. */
  static final int UNTOUCHED = 2000;

  /** What all long curves of a picture may have together: about 300 kB of SVG. */
  static final int BUDGET = 18_000;

  private static final double FINEST_M = 0.0005;
  private static final double FINEST_SHARE = 1.0 / 6000;

  private Thinning() {}

  /** Thins a series in the way that its style allows. */
  static List<PolarPoint> thin(PolarSeries series, double reachM, int longOnes) {
    boolean isCloud = series.style() == SeriesStyle.POINTS;
    return thin(series.points(), reachM, longOnes, isCloud ? Thinning::apart : Thinning::within);
  }

  /**
   * Thins one of {@code curves} curves in a picture that reaches {@code reachM} from its centre.
   */
  private static List<PolarPoint> thin(
      List<PolarPoint> points, double reachM, int curves, Method method) {
    if (points.size() <= UNTOUCHED) {
      return points;
    }
    int limit = Math.max(UNTOUCHED, BUDGET / Math.max(1, curves));
    double toleranceM = Math.max(FINEST_M, reachM * FINEST_SHARE);
    List<PolarPoint> kept = method.thin(points, toleranceM);
    while (kept.size() > limit) {
      toleranceM *= 2;
      kept = method.thin(points, toleranceM);
    }
    return kept;
  }

  /** The first point of a cloud in each square cell of the given side. */
  static List<PolarPoint> apart(List<PolarPoint> points, double sideM) {
    Set<Cell> seen = new HashSet<>();
    return points.stream().filter(p -> seen.add(Cell.of(p, sideM))).toList();
  }

  /** The points of a curve whose edges stay within a tolerance of the curve given. */
  static List<PolarPoint> within(List<PolarPoint> points, double toleranceM) {
    double[] x = points.stream().mapToDouble(PolarPoint::xM).toArray();
    double[] z = points.stream().mapToDouble(PolarPoint::zM).toArray();
    BitSet kept = Corners.needed(x, z, toleranceM);
    List<PolarPoint> result = new ArrayList<>(kept.cardinality());
    kept.stream().forEach(i -> result.add(points.get(i)));
    return result;
  }

  @FunctionalInterface
  private interface Method {
    List<PolarPoint> thin(List<PolarPoint> points, double toleranceM);
  }

  private record Cell(long column, long row) {
    static Cell of(PolarPoint point, double sideM) {
      return new Cell(Math.round(point.xM() / sideM), Math.round(point.zM() / sideM));
    }
  }
}
