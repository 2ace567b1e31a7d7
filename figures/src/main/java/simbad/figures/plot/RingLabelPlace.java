package simbad.figures.plot;

import java.awt.geom.Line2D;
import java.util.List;
import java.util.stream.IntStream;

/** Finds the bearing at which ring labels lie farthest from the curves. */
final class RingLabelPlace {
  /** Half-way between spokes, nearest to the upper right first, which wins a tie. */
  private static final int[] CANDIDATES_DEG = {
    105, 135, 165, 75, 45, 15, 195, 225, 255, 285, 315, 345
  };

  /**
   * Where a label's middle stands outside its ring, and how much room it takes, in outermost radii.
   */
  private static final double LABEL_OFF = 0.04;

  private static final double LABEL_ROOM = 0.09;

  private RingLabelPlace() {}

  /** The bearing in radians, of twelve candidates. */
  static double bearingRad(Rings rings, List<PlotCurve> curves) {
    double best = 0;
    double bestClearance = -1;
    for (int deg : CANDIDATES_DEG) {
      double bearingRad = Math.toRadians(deg);
      double clearance = clearance(rings, curves, bearingRad);
      if (clearance > bestClearance * (1 + 1e-9)) {
        best = bearingRad;
        bestClearance = clearance;
      }
    }
    return best;
  }

  /**
   * The sum over the labels of the distance to the nearest curve, each at most the room it needs.
   */
  private static double clearance(Rings rings, List<PlotCurve> curves, double bearingRad) {
    double reachM = rings.outermostM();
    return rings.radiiM().stream()
        .map(radiusM -> new PolarPoint(bearingRad, radiusM + LABEL_OFF * reachM))
        .mapToDouble(label -> Math.min(LABEL_ROOM * reachM, nearest(curves, label)))
        .sum();
  }

  private static double nearest(List<PlotCurve> curves, PolarPoint label) {
    return curves.stream()
        .mapToDouble(curve -> nearest(curve, label.xM(), -label.zM()))
        .min()
        .orElse(Double.MAX_VALUE);
  }

  private static double nearest(PlotCurve curve, double x, double y) {
    double[] xs = curve.getXData();
    double[] ys = curve.getYData();
    return IntStream.range(0, xs.length)
        .mapToDouble(i -> distance(xs, ys, i, x, y))
        .min()
        .orElse(Double.MAX_VALUE);
  }

  /** To the edge that ends at a point: long edges pass labels far from their ends. */
  private static double distance(double[] xs, double[] ys, int i, double x, double y) {
    int from = Math.max(0, i - 1);
    return Line2D.ptSegDist(xs[from], ys[from], xs[i], ys[i], x, y);
  }
}
