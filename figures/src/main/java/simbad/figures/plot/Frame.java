package simbad.figures.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.Styler.LegendLayout;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;

/**
 * An XY chart stripped to what this package uses of it: axes' ranges and titles, and the legend.
 */
final class Frame {
  private static final double LEGEND_TEXT_SHARE = 0.78;
  private static final Color NONE = new Color(255, 255, 255, 0);

  /** Nothing, then a square half-way along the legend's line. */
  private static final BasicStroke SQUARE =
      new BasicStroke(
          6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 4f, new float[] {0, 16, 6, 90}, 0f);

  private static final String JOIN_ERROR = "sun.java2d.renderer.stroker.joinError";

  static {
    // Java 20 and later leave out the joins of a line's small turns, Java 17 draws them all. Drawn
    // by all, a picture has the same bytes on each. Java reads this once, when it draws first; that
    // is when a chart is laid out.
    if (System.getProperty(JOIN_ERROR) == null) {
      System.setProperty(JOIN_ERROR, "0");
    }
  }

  private Frame() {}

  static XYChart chart(Caption caption, int width, String xTitle, String yTitle) {
    XYChart chart = new XYChart(width, width);
    chart.setTitle(caption.title());
    chart.setXAxisTitle(xTitle);
    chart.setYAxisTitle(yTitle);
    axes(chart.getStyler());
    legend(chart.getStyler());
    return chart;
  }

  private static void axes(XYStyler styler) {
    styler.setChartTitleVisible(false);
    styler.setChartBackgroundColor(PlotInk.PAPER);
    styler.setPlotBackgroundColor(PlotInk.PAPER);
    styler.setChartFontColor(PlotInk.TEXT);
    styler.setPlotBorderVisible(false);
    styler.setPlotContentSize(1);
    styler.setChartPadding(10);
    styler.setPlotMargin(0);
    styler.setPlotGridLinesVisible(false);
    styler.setPlotTicksMarksVisible(false);
    styler.setAxisTicksVisible(false);
    styler.setAxisTitleFont(PlotInk.AXIS_TITLE);
  }

  private static void legend(XYStyler styler) {
    styler.setLegendFont(PlotInk.LEGEND);
    styler.setLegendPosition(LegendPosition.OutsideS);
    styler.setLegendLayout(LegendLayout.Vertical);
    styler.setLegendBackgroundColor(PlotInk.PAPER);
    styler.setLegendBorderColor(NONE);
    styler.setLegendSeriesLineLength(38);
    styler.setLegendPadding(7);
  }

  /** Sets what both axes span. */
  static void range(XYChart chart, double xMin, double xMax, double yMin, double yMax) {
    chart.getStyler().setXAxisMin(xMin).setXAxisMax(xMax).setYAxisMin(yMin).setYAxisMax(yMax);
  }

  /** Adds curves as series, their names broken into lines that fit under the plot. */
  static void add(XYChart chart, List<PlotCurve> curves) {
    curves.forEach(curve -> add(chart, curve));
  }

  private static void add(XYChart chart, PlotCurve curve) {
    String label =
        curve.getXData().length == 0 ? curve.getName() + " (no points)" : curve.getName();
    double width = chart.getWidth() * LEGEND_TEXT_SHARE;
    curve.setLabel(String.join("\n", Text.wrap(label, PlotInk.LEGEND, width)));
    if (chart.getSeriesMap().put(curve.getName(), curve) != null) {
      throw new IllegalArgumentException("series name taken: " + curve.getName());
    }
  }

  /** Adds the legend's key to a filled mark, a square, with the mark's corners as data. */
  static void addMark(XYChart chart, PlotCurve mark) {
    mark.setLineStyle(SQUARE);
    add(chart, mark);
  }

  /**
   * The size at which the plot area is {@code aspect} times as high as wide, to a point. Tick
   * labels stand in the padding of the axis titles.
   */
  static Dimension fit(XYChart chart, Ticks ticks, double aspect) {
    chart.getStyler().setAxisTitlePadding(ticks.room());
    int width = chart.getWidth();
    int height = chart.getHeight();
    for (int pass = 0; pass < 2; pass++) {
      rehearse(chart, new Dimension(width, height));
      PlotScreen screen = new PlotScreen(chart);
      height += (int) Math.round(aspect * screen.plot().getWidth() - screen.plot().getHeight());
    }
    rehearse(chart, new Dimension(width, height));
    return new Dimension(width, height);
  }

  /** Paints into nothing: XChart knows its layout and its ranges only after painting. */
  static void rehearse(XYChart chart, Dimension size) {
    Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
    chart.paint(g, size.width, size.height);
    g.dispose();
  }
}
