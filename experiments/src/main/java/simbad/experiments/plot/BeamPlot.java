package simbad.experiments.plot;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.knowm.xchart.XYChart;

/**
 * How a sensor's sensitivity falls off its axis, beside the cone that stands for it.
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

  /** Copies the lists and checks that they belong together. */
  public BeamPlot {
    offAxisDeg = List.copyOf(offAxisDeg);
    sensitivityDb = List.copyOf(sensitivityDb);
    if (offAxisDeg.size() != sensitivityDb.size()) {
      throw new IllegalArgumentException(
          offAxisDeg.size() + " angles and " + sensitivityDb.size() + " sensitivities");
    }
    Checks.notNegative("coneHalfAngleDeg", coneHalfAngleDeg);
  }

  /** Lays the picture out. */
  public Figure figure() {
    XYChart chart =
        Frame.chart(caption, WIDTH, "angle off the axis (degrees)", "sensitivity, one way (dB)");
    Frame.range(chart, -EDGE_DEG, EDGE_DEG, FLOOR_DB, 0);
    List<Curve> curves = List.of(beam(), cone());
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
    chart.addAnnotation(new Layer(BeamPlot::paintGrid));
    chart.addAnnotation(new Layer(new CurveLayer(curves)));
    chart.addAnnotation(new Layer(ticks));
    return new Figure(caption, chart, size);
  }

  private Curve beam() {
    int n = offAxisDeg.size();
    double[] deg = new double[2 * n];
    double[] db = new double[2 * n];
    for (int i = 0; i < n; i++) {
      deg[n + i] = offAxisDeg.get(i);
      deg[n - 1 - i] = -offAxisDeg.get(i);
      db[n + i] = Math.max(FLOOR_DB, sensitivityDb.get(i));
      db[n - 1 - i] = db[n + i];
    }
    return new Curve("sensitivity", deg, db, Look.of(SeriesRole.SHADOW).slim(), SeriesStyle.LINE);
  }

  private Curve cone() {
    double a = coneHalfAngleDeg;
    return new Curve(
        "cone that stands for it",
        new double[] {-a, -a, a, a},
        new double[] {FLOOR_DB, 0, 0, FLOOR_DB},
        Look.of(SeriesRole.ORIGINAL).slim(),
        SeriesStyle.LINE);
  }

  private static void paintGrid(Graphics2D g, Screen screen) {
    g.setStroke(Ink.HAIRLINE);
    g.setColor(Ink.GRID);
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
