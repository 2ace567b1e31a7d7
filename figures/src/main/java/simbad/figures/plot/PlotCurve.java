package simbad.figures.plot;

import java.util.Arrays;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.internal.chartpart.RenderableSeries.LegendRenderType;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * A series of the chart that XChart lists and ranges but does not draw.
 *
 * <p>XChart draws a line edge by edge. Dashes then start anew at every point, which turns a dense
 * dashed trace into a solid one, and the SVG holds one element per edge. {@link CurveLayer} draws
 * the same data as one path instead.
 */
final class PlotCurve extends XYSeries {
  private final PlotLook look;
  private final SeriesStyle style;

  PlotCurve(String name, double[] x, double[] y, PlotLook look, SeriesStyle style) {
    super(name, x, y, null, DataType.Number);
    this.look = look;
    this.style = style;
    setXYSeriesRenderStyle(XYSeriesRenderStyle.Scatter);
    setMarker(SeriesMarkers.NONE);
    setLineColor(look.colour());
    setLineStyle(look.legendStroke(style));
  }

  PlotLook look() {
    return look;
  }

  SeriesStyle style() {
    return style;
  }

  /** A scatter has no line in the legend; this one has. */
  @Override
  public LegendRenderType getLegendRenderType() {
    return LegendRenderType.Line;
  }

  /** A longer array for a closed curve, its first value repeated at the end. */
  static double[] joined(double[] values, SeriesStyle style) {
    if (style != SeriesStyle.CLOSED_LINE || values.length == 0) {
      return values;
    }
    double[] closed = Arrays.copyOf(values, values.length + 1);
    closed[values.length] = values[0];
    return closed;
  }
}
