package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * The frame of the plot with tick marks and labels below and to the left.
 *
 * <p>XChart's own ticks cannot stand every 30 degrees, label a downward axis or a log axis at 1, 2
 * and 5; they are switched off, and the space of its axis titles' padding is used.
 */
record Ticks(List<Tick> below, List<Tick> left) implements PlotLayer.Painter {
  private static final double LENGTH = 4;
  private static final double GAP = 3;

  /** What a line of labels below takes with some air. */
  private static final double LEAST_ROOM = 21;

  /** A labelled place on an axis, in the chart's coordinate. */
  record Tick(double place, String label) {
    /** A number with a minus, which is longer than a hyphen. */
    static Tick of(double place, double value) {
      return new Tick(place, Steps.label(value).replace('-', '\u2212'));
    }
  }

  Ticks {
    below = List.copyOf(below);
    left = List.copyOf(left);
  }

  /** The room that the labels to the left need beside the plot, in points. */
  int room() {
    double widest =
        left.stream()
            .mapToDouble(tick -> new Text(tick.label(), PlotInk.TICK, PlotInk.TEXT).width())
            .max()
            .orElse(0);
    return (int) Math.ceil(Math.max(LEAST_ROOM, widest + LENGTH + 3 * GAP));
  }

  @Override
  public void paint(Graphics2D g, PlotScreen screen) {
    Rectangle2D plot = screen.plot();
    g.setColor(PlotInk.FRAME);
    g.setStroke(PlotInk.HAIRLINE);
    g.draw(plot);
    below.forEach(tick -> below(g, screen.x(tick.place()), plot.getMaxY(), tick.label()));
    left.forEach(tick -> left(g, plot.getX(), screen.y(tick.place()), tick.label()));
  }

  private static void below(Graphics2D g, double x, double y, String label) {
    mark(g, new Line2D.Double(x, y, x, y + LENGTH));
    new Text(label, PlotInk.TICK, PlotInk.TEXT).draw(g, x, y + LENGTH + GAP, 0.5, 0);
  }

  private static void left(Graphics2D g, double x, double y, String label) {
    mark(g, new Line2D.Double(x - LENGTH, y, x, y));
    new Text(label, PlotInk.TICK, PlotInk.TEXT).draw(g, x - LENGTH - GAP, y, 1, 0.5);
  }

  private static void mark(Graphics2D g, Line2D line) {
    g.setColor(PlotInk.FRAME);
    g.setStroke(PlotInk.HAIRLINE);
    g.draw(line);
  }
}
