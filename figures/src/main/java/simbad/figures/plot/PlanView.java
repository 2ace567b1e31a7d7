package simbad.figures.plot;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.List;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.XYStyler;

/**
 * A square piece of ground round an obstacle, seen from above: the chart's x is the frame's x, its
 * y is the frame's -z, so that z points down the page. A metre is equally long both ways.
 */
final class PlanView {
  private static final int TICKS_PER_SIDE = 5;

  private static final String OBSTACLE = "obstacle";

  private final XYChart chart;
  private final Dimension size;
  private final Ticks ticks;

  private PlanView(XYChart chart, Dimension size, Ticks ticks) {
    this.chart = chart;
    this.size = size;
    this.ticks = ticks;
  }

  /** Lays out a view of the given width in points; layers come afterwards. */
  static PlanView of(Ground ground, int width, double halfWidthM) {
    XYChart chart =
        Frame.chart(ground.caption(), width, "x (m), seen from above", "z (m), down the page");
    Frame.range(chart, -halfWidthM, halfWidthM, -halfWidthM, halfWidthM);
    Frame.add(chart, ground.curves());
    if (!ground.outline().isEmpty()) {
      Frame.addMark(chart, mark(ground.outline()));
    }
    Ticks ticks = ticks(halfWidthM);
    Dimension size = Frame.fit(chart, ticks, 1);
    squareUp(chart, halfWidthM);
    Frame.rehearse(chart, size);
    return new PlanView(chart, size, ticks);
  }

  private static Ticks ticks(double halfWidthM) {
    List<Double> places =
        Steps.multiples(-halfWidthM, halfWidthM, Steps.step(halfWidthM, TICKS_PER_SIDE));
    return new Ticks(
        places.stream().map(x -> Ticks.Tick.of(x, x)).toList(),
        places.stream().map(z -> Ticks.Tick.of(0 - z, z)).toList());
  }

  /** What a plan view shows. */
  record Ground(Caption caption, List<PlotCurve> curves, List<PolarPoint> outline) {}

  /** The size in whole points leaves half a point over, which goes to z's range. */
  private static void squareUp(XYChart chart, double halfWidthM) {
    PlotScreen screen = new PlotScreen(chart);
    double halfHeightM = halfWidthM * screen.plot().getHeight() / screen.plot().getWidth();
    XYStyler styler = chart.getStyler();
    styler.setYAxisMin(-halfHeightM).setYAxisMax(halfHeightM);
  }

  XYChart chart() {
    return chart;
  }

  Dimension size() {
    return size;
  }

  void add(PlotLayer.Painter painter) {
    chart.addAnnotation(new PlotLayer(painter));
  }

  /** Adds frame, ticks and labels; last, so that they lie over everything. */
  void addTicks() {
    add(ticks);
  }

  /** Adds the obstacle as a filled mark; a seam keeps a small one visible in a large picture. */
  void addOutline(List<PolarPoint> outline) {
    if (!outline.isEmpty()) {
      add((g, screen) -> paintOutline(g, screen, outline));
    }
  }

  private static void paintOutline(Graphics2D g, PlotScreen screen, List<PolarPoint> outline) {
    double[] x = outline.stream().mapToDouble(PolarPoint::xM).toArray();
    double[] y = outline.stream().mapToDouble(p -> -p.zM()).toArray();
    Path2D path = screen.path(x, y, 0, x.length);
    path.closePath();
    g.setColor(PlotInk.OBSTACLE);
    g.setStroke(PlotInk.round(1.2f));
    g.fill(path);
    g.draw(path);
  }

  /** The curves of a picture that reaches so far from its centre; long ones are thinned. */
  static List<PlotCurve> curves(List<PolarSeries> series, double reachM) {
    int longOnes =
        (int) series.stream().filter(s -> s.points().size() > Thinning.UNTOUCHED).count();
    return series.stream().map(s -> curve(s, Thinning.thin(s, reachM, longOnes))).toList();
  }

  private static PlotCurve mark(List<PolarPoint> outline) {
    PolarSeries corners =
        new PolarSeries(OBSTACLE, SeriesRole.OTHER, SeriesStyle.CLOSED_LINE, outline);
    PlotCurve mark = curve(corners, outline);
    mark.setLineColor(PlotInk.OBSTACLE);
    return mark;
  }

  private static PlotCurve curve(PolarSeries series, List<PolarPoint> points) {
    double[] x = points.stream().mapToDouble(PolarPoint::xM).toArray();
    double[] y = points.stream().mapToDouble(p -> 0 - p.zM()).toArray();
    return new PlotCurve(
        series.name(),
        PlotCurve.joined(x, series.style()),
        PlotCurve.joined(y, series.style()),
        PlotLook.of(series.role()).withPattern(series.pattern()),
        series.style());
  }
}
