package simbad.figures.plot;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.knowm.xchart.XYChart;
import simbad.sonar.check.Checks;

/**
 * How a sensor's sensitivity falls off its axis, beside the cone that stands for it. Nothing is
 * known between the given angles: where they lie further apart than {@value #FINE_DEG} degrees each
 * has a dot, so that the corners of the line are not taken for the sensor's. What lies below the
 * axis is cut off, not drawn on it.
 *
 * @param caption title and provenance, both always shown
 * @param offAxisDeg angles off the axis, rising from 0, degrees
 * @param sensitivityDb one way, 0 on the axis, as many
 * @param coneHalfAngleDeg of the cone
 */
public record BeamPlot(
    Caption caption, List<Double> offAxisDeg, List<Double> sensitivityDb, double coneHalfAngleDeg) {
  private static final int WIDTH = 540;
  private static final double ASPECT = 0.5;
  private static final double EDGE_DEG = 90;
  private static final double FLOOR_DB = -36;
  private static final double TICK_DEG = 30;
  private static final double TICK_DB = 6;

  /** Lines between angles this near look smooth. */
  private static final double FINE_DEG = 2;

  private static final float DOT = 1.8f;

  /** Copies the lists and checks that they belong together. */
  public BeamPlot {
    offAxisDeg = List.copyOf(offAxisDeg);
    sensitivityDb = List.copyOf(sensitivityDb);
    if (offAxisDeg.size() != sensitivityDb.size()) {
      throw new IllegalArgumentException(
          offAxisDeg.size() + " angles and " + sensitivityDb.size() + " sensitivities");
    }
    Checks.numbers("offAxisDeg", offAxisDeg);
    Checks.numbers("sensitivityDb", sensitivityDb);
    Checks.notNegative("coneHalfAngleDeg", coneHalfAngleDeg);
  }

  /** Lays the picture out. */
  public PlotFigure figure() {
    XYChart chart =
        Frame.chart(caption, WIDTH, "angle off the axis (degrees)", "sensitivity, one way (dB)");
    Frame.range(chart, -EDGE_DEG, EDGE_DEG, FLOOR_DB, 0);
    List<PlotCurve> curves = curves();
    Frame.add(chart, curves);
    Ticks ticks =
        new Ticks(
            Steps.multiples(-EDGE_DEG, EDGE_DEG, TICK_DEG).stream()
                .map(deg -> Ticks.Tick.of(deg, deg))
                .toList(),
            Steps.multiples(FLOOR_DB, 0, TICK_DB).stream()
                .map(db -> Ticks.Tick.of(db, db))
                .toList());
    Dimension size = Frame.fit(chart, ticks, ASPECT);
    chart.addAnnotation(new PlotLayer(BeamPlot::paintGrid));
    chart.addAnnotation(new PlotLayer(new CurveLayer(curves)));
    chart.addAnnotation(new PlotLayer(ticks));
    return new PlotFigure(caption, chart, size);
  }

  private List<PlotCurve> curves() {
    return isFine() ? List.of(beam(), cone()) : List.of(beam(), dots(), cone());
  }

  private boolean isFine() {
    return IntStream.range(1, offAxisDeg.size())
        .allMatch(i -> offAxisDeg.get(i) - offAxisDeg.get(i - 1) <= FINE_DEG);
  }

  private PlotCurve beam() {
    List<double[]> points = new ArrayList<>();
    double[] before = null;
    for (double[] point : bothSides()) {
      add(points, before, point);
      before = point;
    }
    return new PlotCurve(
        "sensitivity",
        points.stream().mapToDouble(p -> p[0]).toArray(),
        points.stream().mapToDouble(p -> p[1]).toArray(),
        PlotLook.of(SeriesRole.SHADOW).slim(),
        SeriesStyle.LINE);
  }

  /** Ends the line where it leaves the plot, and begins it where it comes back. */
  private static void add(List<double[]> points, double @Nullable [] before, double[] point) {
    boolean isIn = point[1] >= FLOOR_DB;
    if (before != null && before[1] >= FLOOR_DB != isIn) {
      double share = (FLOOR_DB - before[1]) / (point[1] - before[1]);
      double deg = before[0] + share * (point[0] - before[0]);
      points.add(new double[] {deg, isIn ? Double.NaN : FLOOR_DB});
      points.add(new double[] {deg, isIn ? FLOOR_DB : Double.NaN});
    }
    if (isIn) {
      points.add(point);
    }
  }

  private PlotCurve dots() {
    List<double[]> points = bothSides().stream().filter(p -> p[1] >= FLOOR_DB).toList();
    PlotLook line = PlotLook.of(SeriesRole.SHADOW);
    return new PlotCurve(
        "points from the sensor's file",
        points.stream().mapToDouble(p -> p[0]).toArray(),
        points.stream().mapToDouble(p -> p[1]).toArray(),
        new PlotLook(line.colour(), PlotInk.round(DOT), line.depth()),
        SeriesStyle.POINTS);
  }

  /** Angle and level from the far left to the far right, the axis twice. */
  private List<double[]> bothSides() {
    List<double[]> points = new ArrayList<>();
    for (int i = offAxisDeg.size() - 1; i >= 0; i--) {
      points.add(new double[] {0 - offAxisDeg.get(i), sensitivityDb.get(i)});
    }
    for (int i = 0; i < offAxisDeg.size(); i++) {
      points.add(new double[] {offAxisDeg.get(i), sensitivityDb.get(i)});
    }
    return points;
  }

  private PlotCurve cone() {
    double a = coneHalfAngleDeg;
    return new PlotCurve(
        "cone that stands for it",
        new double[] {-a, -a, a, a},
        new double[] {FLOOR_DB, 0, 0, FLOOR_DB},
        PlotLook.of(SeriesRole.ORIGINAL).slim(),
        SeriesStyle.LINE);
  }

  private static void paintGrid(Graphics2D g, PlotScreen screen) {
    g.setStroke(PlotInk.HAIRLINE);
    g.setColor(PlotInk.GRID);
    Rectangle2D plot = screen.plot();
    for (double db : Steps.multiples(FLOOR_DB, 0, TICK_DB)) {
      double y = Paths.rounded(screen.y(db));
      g.draw(new Line2D.Double(plot.getX(), y, plot.getMaxX(), y));
    }
    for (double deg : Steps.multiples(-EDGE_DEG, EDGE_DEG, TICK_DEG)) {
      double x = Paths.rounded(screen.x(deg));
      g.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
    }
  }
}
