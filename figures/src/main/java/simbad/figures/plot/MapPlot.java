package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import simbad.experiments.run.ShareGrid;

/**
 * A share at every place round an obstacle as a coloured map, with threshold tables drawn over it.
 *
 * <p>Seen from above in the obstacle's own frame: x to the right, z down the page; both directions
 * have one scale. Pale is 0, dark is 1. What reaches beyond the grid is cut off.
 *
 * @param caption title and provenance, both always shown
 * @param quantity what the share is of, for the colour bar; not blank
 * @param grid the shares
 * @param series what is drawn over the map, such as the table; names distinct; may be empty
 * @param outline the obstacle's cross-section, drawn filled and called "obstacle" in the legend;
 *     may be empty
 */
public record MapPlot(
    Caption caption,
    String quantity,
    ShareGrid grid,
    List<PolarSeries> series,
    List<PolarPoint> outline) {
  private static final int WIDTH = 428;

  /** Copies the lists. */
  public MapPlot {
    Labels.notBlank("quantity", quantity);
    series = List.copyOf(series);
    outline = List.copyOf(outline);
    Labels.distinctNames(series, PolarSeries::name);
  }

  /** Lays the picture out. */
  public PlotFigure figure() {
    List<PlotCurve> curves = PlanView.curves(series, grid.halfWidthM());
    PlanView view =
        PlanView.of(new PlanView.Ground(caption, curves, outline), WIDTH, grid.halfWidthM());
    BufferedImage image =
        Tiles.image(
            grid.cells(),
            grid.cells(),
            (column, row) -> Ramp.colour(grid.share(column, row)).getRGB());
    view.add((g, screen) -> Tiles.draw(g, image, screen.plot()));
    view.add((g, screen) -> paintCurves(g, screen, curves));
    view.addOutline(outline);
    view.addTicks();
    return new PlotFigure(caption, view.chart(), view.size(), Optional.of(new ColourBar(quantity)));
  }

  /** A pale seam keeps a dark curve visible on dark cells. */
  private static void paintCurves(Graphics2D g, PlotScreen screen, List<PlotCurve> curves) {
    Shape before = g.getClip();
    g.setClip(screen.plot());
    CurveLayer layer = new CurveLayer(curves);
    layer.paintSeams(g, screen);
    layer.paint(g, screen);
    g.setClip(before);
  }
}
