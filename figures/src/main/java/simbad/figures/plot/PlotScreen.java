package simbad.figures.plot;

import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.knowm.xchart.internal.chartpart.Chart;
import org.knowm.xchart.style.AxesChartStyler;

/** Where a chart's coordinates lie on the page, in points from the chart's upper left corner. */
final class PlotScreen {
  private final Chart<?, ?> chart;

  PlotScreen(Chart<?, ?> chart) {
    this.chart = chart;
  }

  double x(double chartX) {
    return chart.getScreenXFromChart(chartX);
  }

  double y(double chartY) {
    return chart.getScreenYFromChart(chartY);
  }

  /** The plot area. */
  Rectangle2D plot() {
    AxesChartStyler styler = (AxesChartStyler) chart.getStyler();
    double left = x(styler.getXAxisMin());
    double top = y(styler.getYAxisMax());
    return new Rectangle2D.Double(
        left, top, x(styler.getXAxisMax()) - left, y(styler.getYAxisMin()) - top);
  }

  /** A path through the points from one index up to another, the second excluded. */
  Path2D path(double[] xs, double[] ys, int from, int to) {
    Path2D path = new Path2D.Double();
    for (int i = from; i < to; i++) {
      double px = Paths.rounded(x(xs[i]));
      double py = Paths.rounded(y(ys[i]));
      if (i == from) {
        path.moveTo(px, py);
      } else {
        path.lineTo(px, py);
      }
    }
    return path;
  }
}
