package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The polar grid: rings at round distances and spokes every 30 degrees.
 *
 * @param stepM from ring to ring, in metres
 * @param count how many rings
 */
record Rings(double stepM, int count) {
  private static final int MOST_RINGS = 7;
  private static final int SPOKE_STEP_DEG = 30;
  private static final double EMPTY_REACH_M = 1;

  /** Where the labels of the spokes stand, and where the picture ends, in outermost radii. */
  private static final double LABEL_SHARE = 1.075;

  private static final double EDGE_SHARE = 1.16;

  /** From a ring to the box of its label, in points. */
  private static final double LABEL_GAP = 2;

  /** Rings that hold everything within a radius; a metre where there is nothing to hold. */
  static Rings around(double radiusM) {
    double reachM = radiusM > 0 ? radiusM : EMPTY_REACH_M;
    double stepM = Steps.step(reachM, MOST_RINGS);
    return new Rings(stepM, Steps.count(reachM, stepM));
  }

  double outermostM() {
    return stepM * count;
  }

  /** Half the side of the square that has room for rings and spoke labels. */
  double halfWidthM() {
    return outermostM() * EDGE_SHARE;
  }

  List<Double> radiiM() {
    return IntStream.rangeClosed(1, count).mapToObj(i -> i * stepM).toList();
  }

  void paintGrid(Graphics2D g, PlotScreen screen) {
    g.setColor(PlotInk.GRID);
    g.setStroke(PlotInk.HAIRLINE);
    radiiM().forEach(radiusM -> g.draw(ring(screen, radiusM)));
    for (int deg = 0; deg < 360; deg += SPOKE_STEP_DEG) {
      PolarPoint tip = new PolarPoint(Math.toRadians(deg), outermostM());
      g.draw(new Line2D.Double(x(screen, 0), y(screen, 0), px(screen, tip), py(screen, tip)));
    }
  }

  private static Ellipse2D ring(PlotScreen screen, double radiusM) {
    double left = x(screen, -radiusM);
    double top = y(screen, radiusM);
    return new Ellipse2D.Double(left, top, x(screen, radiusM) - left, y(screen, -radiusM) - top);
  }

  void paintSpokeLabels(Graphics2D g, PlotScreen screen) {
    for (int deg = 0; deg < 360; deg += SPOKE_STEP_DEG) {
      PolarPoint at = new PolarPoint(Math.toRadians(deg), outermostM() * LABEL_SHARE);
      new Text(deg + "°", PlotInk.TICK, PlotInk.SOFT_TEXT)
          .drawWithHalo(g, px(screen, at), py(screen, at));
    }
  }

  /** Labels the rings along a bearing, just outside them: a trace may well run along a ring. */
  void paintRingLabels(Graphics2D g, PlotScreen screen, double bearingRad) {
    for (double radiusM : radiiM()) {
      PolarPoint at = new PolarPoint(bearingRad, radiusM);
      Text label = new Text(Steps.label(radiusM) + " m", PlotInk.RING, PlotInk.SOFT_TEXT);
      double off = label.reach(bearingRad) + LABEL_GAP;
      double dx = off * Math.sin(bearingRad);
      double dy = off * Math.cos(bearingRad);
      label.drawWithHalo(g, px(screen, at) + dx, py(screen, at) + dy);
    }
  }

  private static double px(PlotScreen screen, PolarPoint point) {
    return screen.x(point.xM());
  }

  private static double py(PlotScreen screen, PolarPoint point) {
    return screen.y(-point.zM());
  }

  private static double x(PlotScreen screen, double value) {
    return Paths.rounded(screen.x(value));
  }

  private static double y(PlotScreen screen, double value) {
    return Paths.rounded(screen.y(value));
  }
}
