package simbad.figures.plot;

import java.awt.Graphics2D;
import org.knowm.xchart.internal.chartpart.Annotation;

/** Something drawn in the coordinates of a chart, over what was added before it. */
final class PlotLayer extends Annotation {
  private final Painter painter;

  PlotLayer(Painter painter) {
    super(false);
    this.painter = painter;
  }

  @Override
  public void paint(Graphics2D g) {
    painter.paint(g, new PlotScreen(chart));
  }

  /** Draws with the chart's coordinates at hand. */
  @FunctionalInterface
  interface Painter {
    void paint(Graphics2D g, PlotScreen screen);
  }
}
