package simbad.figures.plot;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import org.knowm.xchart.XYChart;

/**
 * A picture that is laid out and can be drawn, as often as need be and always with the same bytes.
 * Works without a display.
 *
 * <p>Title and provenance also stand in the files as plain text: in the SVG's {@code title} and
 * {@code desc}, in the PNG's {@code Title} and {@code Description}. Instances are not thread-safe:
 * the chart lays itself out anew each time that it is painted.
 */
public final class PlotFigure {
  /** Resolution of print. */
  public static final int PRINT_DPI = 300;

  private final Caption caption;
  private final XYChart chart;
  private final Dimension chartSize;
  private final PlotHeading heading;
  private final Optional<ColourBar> bar;

  PlotFigure(Caption caption, XYChart chart, Dimension chartSize) {
    this(caption, chart, chartSize, Optional.empty());
  }

  PlotFigure(Caption caption, XYChart chart, Dimension chartSize, Optional<ColourBar> bar) {
    this.caption = caption;
    this.chart = chart;
    this.chartSize = chartSize;
    this.bar = bar;
    this.heading = PlotHeading.of(caption, chartSize.width);
  }

  /** The chart with its series, ranges and titles, for reading; title and bar lie outside it. */
  public XYChart chart() {
    return chart;
  }

  /** What stands over the picture and in its file's description. */
  public Caption caption() {
    return caption;
  }

  /** The width in points, 72 to the inch. */
  public int widthPt() {
    return chartSize.width + bar.map(ColourBar::widthPt).orElse(0);
  }

  /** The height in points. */
  public int heightPt() {
    return chartSize.height + heading.heightPt();
  }

  /**
   * The picture as PNG.
   *
   * @param dpi pixels to the inch, 1 to 1200; the file carries it
   */
  public byte[] png(int dpi) {
    return new PngWriter(dpi).write(this);
  }

  /** The picture as SVG 1.1, a point being one unit. */
  public byte[] svg() {
    return SvgWriter.write(this);
  }

  /** Draws everything, one unit being a point. */
  void paint(Graphics2D g) {
    g.setColor(PlotInk.PAPER);
    g.fillRect(0, 0, widthPt(), heightPt());
    g.translate(0, heading.heightPt());
    chart.paint(g, chartSize.width, chartSize.height);
    PlotScreen screen = new PlotScreen(chart);
    bar.ifPresent(colours -> colours.paint(g, chartSize.width, screen.plot()));
    heading.paint(g, screen.plot().getX());
  }

  /** Title and provenance over a chart, in as many lines as they take. */
  private record PlotHeading(List<String> title, List<String> provenance) {
    private static final int TOP = 12;
    private static final int TITLE_LINE = 16;
    private static final int PROVENANCE_LINE = 13;

    /** What the axis to the left and the margin to the right leave of the width. */
    private static final double TEXT_SHARE = 0.84;

    static PlotHeading of(Caption caption, int width) {
      return new PlotHeading(
          Text.wrap(caption.title(), PlotInk.TITLE, width * TEXT_SHARE),
          Text.wrap(caption.provenance(), PlotInk.PROVENANCE, width * TEXT_SHARE));
    }

    int heightPt() {
      return TOP + title.size() * TITLE_LINE + provenance.size() * PROVENANCE_LINE;
    }

    /** Draws upwards from the origin, flush with the plot's left edge. */
    void paint(Graphics2D g, double left) {
      double y = TOP - heightPt();
      for (String line : title) {
        new Text(line, PlotInk.TITLE, PlotInk.TEXT).draw(g, left, y, 0, 0);
        y += TITLE_LINE;
      }
      for (String line : provenance) {
        new Text(line, PlotInk.PROVENANCE, PlotInk.SOFT_TEXT).draw(g, left, y, 0, 0);
        y += PROVENANCE_LINE;
      }
    }
  }
}
