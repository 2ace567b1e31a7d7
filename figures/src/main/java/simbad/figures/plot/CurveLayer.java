package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import java.util.Comparator;
import java.util.List;

/** Draws curves as single paths, the deepest first. */
final class CurveLayer implements PlotLayer.Painter {
  /** Above this many corners their dots would run into a band. */
  private static final int MOST_MARKED = 400;

  private static final float SEAM = 1.8f;

  private final List<PlotCurve> curves;

  CurveLayer(List<PlotCurve> curves) {
    this.curves = curves.stream().sorted(Comparator.comparingInt(c -> c.look().depth())).toList();
  }

  @Override
  public void paint(Graphics2D g, PlotScreen screen) {
    curves.forEach(curve -> paint(g, screen, curve));
  }

  /** Draws a pale band where the lines will lie. */
  void paintSeams(Graphics2D g, PlotScreen screen) {
    g.setColor(PlotInk.PAPER);
    for (PlotCurve curve : curves) {
      if (isLine(curve)) {
        g.setStroke(PlotInk.round(curve.look().stroke().getLineWidth() + SEAM));
        strokes(g, screen, curve);
      }
    }
  }

  private static void paint(Graphics2D g, PlotScreen screen, PlotCurve curve) {
    g.setColor(curve.look().colour());
    g.setStroke(curve.look().stroke());
    if (curve.style() == SeriesStyle.AREA) {
      g.fill(screen.path(curve.getXData(), curve.getYData(), 0, curve.getXData().length));
    }
    if (isLine(curve)) {
      strokes(g, screen, curve);
    }
    if (curve.style() == SeriesStyle.POINTS || isMarked(curve)) {
      dots(g, screen, curve, 0, curve.getXData().length);
    }
  }

  private static boolean isLine(PlotCurve curve) {
    return curve.style() == SeriesStyle.LINE || curve.style() == SeriesStyle.CLOSED_LINE;
  }

  /** The corners of a table are data, its edges are not. */
  private static boolean isMarked(PlotCurve curve) {
    boolean isTable = curve.look().equals(PlotLook.of(SeriesRole.TABLE));
    return isTable && curve.getXData().length <= MOST_MARKED;
  }

  /**
   * A value that is not a number, which XChart takes for a gap, ends one path and starts another.
   */
  private static void strokes(Graphics2D g, PlotScreen screen, PlotCurve curve) {
    double[] y = curve.getYData();
    int from = 0;
    for (int i = 0; i <= y.length; i++) {
      if (i == y.length || Double.isNaN(y[i])) {
        stroke(g, screen, curve, from, i);
        from = i + 1;
      }
    }
  }

  /** A point between two gaps has no edge to be seen by. */
  private static void stroke(Graphics2D g, PlotScreen screen, PlotCurve curve, int from, int to) {
    if (to - from >= 2) {
      g.draw(screen.path(curve.getXData(), curve.getYData(), from, to));
    } else if (to - from == 1) {
      Stroke line = g.getStroke();
      dots(g, screen, curve, from, to);
      g.setStroke(line);
    }
  }

  /** One path for all dots: strokes so short that their round caps are all there is of them. */
  private static void dots(Graphics2D g, PlotScreen screen, PlotCurve curve, int from, int to) {
    Path2D path = new Path2D.Double();
    for (int i = from; i < to; i++) {
      double y = curve.getYData()[i];
      if (!Double.isNaN(y)) {
        dot(path, Paths.rounded(screen.x(curve.getXData()[i])), Paths.rounded(screen.y(y)));
      }
    }
    g.setStroke(PlotInk.round(curve.look().dotSize()));
    g.draw(path);
  }

  private static void dot(Path2D path, double x, double y) {
    path.moveTo(x, y);
    path.lineTo(Paths.rounded(x + 0.01), y);
  }
}
