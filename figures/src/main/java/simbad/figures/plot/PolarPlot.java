package simbad.figures.plot;

import java.util.List;

/**
 * Curves round an obstacle over rings and spokes: a threshold table, and the traces of a robot that
 * followed its edge.
 *
 * <p>Seen from above in the obstacle's own frame: x to the right, z down the page, bearing 0 at the
 * bottom, 90 to the right. Both directions have one scale. Curves of more than 2000 points (traces)
 * are thinned: what is drawn stays within 0.5 mm of what was given, or within 1/6000 of the
 * picture's half width where that is more, unless all such curves together keep over 18,000 points;
 * then the tolerance is doubled until they do not. The SVG so stays under 500 kB.
 *
 * @param caption title and provenance, both always shown
 * @param series the curves in the legend's order, names distinct; who lies over whom follows from
 *     their roles
 * @param outline the obstacle's cross-section, drawn filled and called "obstacle" in the legend;
 *     may be empty
 */
public record PolarPlot(Caption caption, List<PolarSeries> series, List<PolarPoint> outline) {
  private static final int WIDTH = 468;

  /** Copies the lists. */
  public PolarPlot {
    series = List.copyOf(series);
    outline = List.copyOf(outline);
    Labels.distinctNames(series, PolarSeries::name);
  }

  /** Lays the picture out. */
  public PlotFigure figure() {
    double reachM = series.stream().mapToDouble(PolarSeries::largestRadiusM).max().orElse(0);
    Rings rings = Rings.around(reachM);
    List<PlotCurve> curves = PlanView.curves(series, rings.outermostM());
    PlanView view =
        PlanView.of(new PlanView.Ground(caption, curves, outline), WIDTH, rings.halfWidthM());
    double labelsAtRad = RingLabelPlace.bearingRad(rings, curves);
    view.add(rings::paintGrid);
    view.addOutline(outline);
    view.add(new CurveLayer(curves));
    view.add((g, screen) -> rings.paintRingLabels(g, screen, labelsAtRad));
    view.add(rings::paintSpokeLabels);
    view.addTicks();
    return new PlotFigure(caption, view.chart(), view.size());
  }
}
