package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/**
 * The key to the colours of a map, to the right of its plot: 0 at the bottom, 1 at the top.
 *
 * @param quantity what the share is of
 */
record ColourBar(String quantity) {
  private static final int WIDTH = 62;
  private static final double BAR = 13;
  private static final int SHADES = 240;
  private static final double TITLE_AT = 47;
  private static final double TICK = 3;

  int widthPt() {
    return WIDTH;
  }

  /** Draws beside a plot, from the given x on. */
  void paint(Graphics2D g, double left, Rectangle2D plot) {
    Rectangle2D bar = new Rectangle2D.Double(left, plot.getY(), BAR, plot.getHeight());
    Tiles.draw(g, Tiles.image(1, SHADES, (column, row) -> shade(row)), bar);
    g.setColor(PlotInk.FRAME);
    g.setStroke(PlotInk.HAIRLINE);
    g.draw(bar);
    Steps.multiples(0, 1, 0.2).forEach(share -> tick(g, bar, share));
    new Text(quantity, PlotInk.AXIS_TITLE, PlotInk.TEXT)
        .drawUpwards(g, left + TITLE_AT, bar.getCenterY());
  }

  private static int shade(int row) {
    return Ramp.colour(1 - (row + 0.5) / SHADES).getRGB();
  }

  private static void tick(Graphics2D g, Rectangle2D bar, double share) {
    double y = bar.getMaxY() - share * bar.getHeight();
    g.setColor(PlotInk.FRAME);
    g.draw(new Line2D.Double(bar.getMaxX(), y, bar.getMaxX() + TICK, y));
    new Text(Steps.label(share), PlotInk.TICK, PlotInk.TEXT)
        .draw(g, bar.getMaxX() + TICK + 3, y, 0, 0.5);
  }
}
