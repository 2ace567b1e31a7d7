package simbad.figures.plot;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.XYChart;

/**
 * Radial error |r - T| in centimetres over the table's bearings from 0 to 360 degrees, a curve for
 * each sensor.
 *
 * <p>The axis is logarithmic where the largest error exceeds twenty times the least (0.1 mm
 * counting as the least), which is the rule near a table's corners; errors too small for it are
 * drawn at its bottom, whose label then begins with "≤". A curve breaks where bearings are missing,
 * and its value at 0 is repeated at 360.
 *
 * <p>Behind the curves stand the table's lobes, so that one sees whose error is of a lobe that was
 * cut off.
 *
 * @param caption title and provenance, both always shown
 * @param series the sensors in the legend's order, names distinct
 * @param table its thresholds by rising bearing from 0; empty for no lobes
 */
public record ErrorPlot(Caption caption, List<ErrorSeries> series, List<PolarPoint> table) {
  private static final int WIDTH = 540;
  private static final String Y_TITLE = "radial error |r − T| (cm)";
  private static final double ASPECT = 0.46;
  private static final double CM_PER_M = 100;
  private static final double TURN_DEG = 360;
  private static final double TICK_DEG = 30;

  /** The largest lobe, as a share of the plot's height. */
  private static final double LOBE = 0.94;

  /** Copies the lists. */
  public ErrorPlot {
    series = List.copyOf(series);
    table = List.copyOf(table);
    Labels.distinctNames(series, ErrorSeries::name);
  }

  /** A plot without lobes. */
  public ErrorPlot(Caption caption, List<ErrorSeries> series) {
    this(caption, series, List.of());
  }

  /** Tells whether the error's axis is logarithmic. */
  public boolean isLogarithmic() {
    return scale().isLog();
  }

  /** Lays the picture out. */
  public PlotFigure figure() {
    ErrorScale scale = scale();
    XYChart chart = Frame.chart(caption, WIDTH, "bearing in the table (degrees)", Y_TITLE);
    chart.getStyler().setYAxisLogarithmic(scale.isLog());
    Frame.range(chart, 0, TURN_DEG, scale.bottomCm(), scale.topCm());
    List<PlotCurve> curves = series.stream().map(s -> curve(s, scale)).toList();
    List<PlotCurve> lobes = lobes(scale);
    Frame.add(chart, curves);
    Frame.add(chart, lobes);
    Ticks ticks = ticks(scale);
    Dimension size = Frame.fit(chart, ticks, ASPECT);
    chart.addAnnotation(new PlotLayer(new CurveLayer(lobes)));
    chart.addAnnotation(new PlotLayer((g, screen) -> paintGrid(g, screen, scale)));
    chart.addAnnotation(new PlotLayer(new CurveLayer(curves)));
    chart.addAnnotation(new PlotLayer(ticks));
    return new PlotFigure(caption, chart, size);
  }

  /** Returns the scale of the error's axis. */
  public ErrorScale scale() {
    return ErrorScale.of(
        series.stream()
            .flatMap(s -> s.errors().stream())
            .mapToDouble(e -> e.errorM() * CM_PER_M)
            .toArray());
  }

  /** Thresholds have no axis of their own: the legend says how far the largest reaches. */
  private List<PlotCurve> lobes(ErrorScale scale) {
    double mostM = table.stream().mapToDouble(PolarPoint::radiusM).max().orElse(0);
    if (!(mostM > 0)) {
      return List.of();
    }
    int last = table.size();
    double[] deg = new double[last + 3];
    double[] cm = new double[last + 3];
    for (int i = 0; i <= last; i++) {
      PolarPoint point = table.get(i % last);
      deg[i] = i < last ? Math.toDegrees(point.bearingRad()) : TURN_DEG;
      cm[i] = scale.at(LOBE * point.radiusM() / mostM);
    }
    deg[last + 1] = TURN_DEG;
    cm[last + 1] = scale.bottomCm();
    cm[last + 2] = scale.bottomCm();
    String name = "the table's lobes, the largest " + Steps.label(mostM) + " m";
    return List.of(new PlotCurve(name, deg, cm, PlotLook.of(SeriesRole.BAND), SeriesStyle.AREA));
  }

  private static PlotCurve curve(ErrorSeries series, ErrorScale scale) {
    List<double[]> points = new ArrayList<>();
    double widestDeg = 1.5 * leastStepDeg(series.errors());
    for (BearingError error : series.errors()) {
      add(points, error.bearingDeg(), scale.clamped(error.errorM() * CM_PER_M), widestDeg);
    }
    if (!points.isEmpty() && points.get(0)[0] == 0) {
      // A full turn later is the same bearing: the graph ends where it began.
      add(points, TURN_DEG, points.get(0)[1], widestDeg);
    }
    return new PlotCurve(
        series.name(),
        column(points, 0),
        column(points, 1),
        PlotLook.of(series.role()).slim().withPattern(series.pattern()),
        SeriesStyle.LINE);
  }

  private static void add(List<double[]> points, double deg, double cm, double widestDeg) {
    if (!points.isEmpty() && deg - points.get(points.size() - 1)[0] > widestDeg) {
      // XChart's sign for a break in a line.
      points.add(new double[] {deg, Double.NaN});
    }
    points.add(new double[] {deg, cm});
  }

  private static double[] column(List<double[]> points, int index) {
    return points.stream().mapToDouble(p -> p[index]).toArray();
  }

  private static double leastStepDeg(List<BearingError> errors) {
    double least = TURN_DEG;
    for (int i = 1; i < errors.size(); i++) {
      double step = errors.get(i).bearingDeg() - errors.get(i - 1).bearingDeg();
      least = step > 0 ? Math.min(least, step) : least;
    }
    return least;
  }

  private static void paintGrid(Graphics2D g, PlotScreen screen, ErrorScale scale) {
    g.setStroke(PlotInk.HAIRLINE);
    scale.fineLines().forEach(cm -> across(g, screen, cm, PlotInk.FINE_GRID));
    scale.ticks().forEach(cm -> across(g, screen, cm, PlotInk.GRID));
    Rectangle2D plot = screen.plot();
    for (double deg : Steps.multiples(0, TURN_DEG, TICK_DEG)) {
      double x = Paths.rounded(screen.x(deg));
      g.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
    }
  }

  private static void across(Graphics2D g, PlotScreen screen, double cm, Color colour) {
    Rectangle2D plot = screen.plot();
    double y = Paths.rounded(screen.y(cm));
    g.setColor(colour);
    g.draw(new Line2D.Double(plot.getX(), y, plot.getMaxX(), y));
  }

  private static Ticks ticks(ErrorScale scale) {
    List<Double> degrees = Steps.multiples(0, TURN_DEG, TICK_DEG);
    return new Ticks(
        degrees.stream().map(deg -> Ticks.Tick.of(deg, deg)).toList(),
        scale.ticks().stream().map(cm -> new Ticks.Tick(cm, scale.label(cm))).toList());
  }
}
