package simbad.figures.plot;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.XYChart;

/**
 * What was claimed, to the right, against what was found, upward, on one scale: points on the
 * diagonal were claimed rightly. A reliability diagram is one (Murphy and Winkler 1977, Applied
 * Statistics 26, 41).
 *
 * <p>Points beyond the scale are drawn at its edge. A label that would lie over an earlier one is
 * left out.
 *
 * @param caption title and provenance, both always shown
 * @param axes titles and span of both axes
 * @param series what the points are called in the legend; not blank
 * @param points in any order; may be empty
 */
public record AgreementPlot(
    Caption caption, Axes axes, String series, List<AgreementPoint> points) {
  private static final int WIDTH = 400;
  private static final int PARTS = 5;
  private static final double LABEL_GAP = 5;

  /** Of the line that the dots' size follows from. */
  private static final float DOT = 3;

  /**
   * Both axes.
   *
   * @param claimed title to the right
   * @param found title upward
   * @param least where both begin
   * @param most where both end, above {@code least}
   */
  public record Axes(String claimed, String found, double least, double most) {
    /** Refuses an empty span. */
    public Axes {
      if (!(most > least)) {
        throw new IllegalArgumentException("most = " + most + " is not above least = " + least);
      }
    }
  }

  /** Copies the list. */
  public AgreementPlot {
    Checks.notBlank("series", series);
    points = List.copyOf(points);
  }

  /** Lays the picture out. */
  public Figure figure() {
    XYChart chart = Frame.chart(caption, WIDTH, axes.claimed(), axes.found());
    Frame.range(chart, axes.least(), axes.most(), axes.least(), axes.most());
    Curve diagonal = diagonal();
    Curve dots = dots();
    Frame.add(chart, List.of(diagonal, dots));
    Ticks ticks = new Ticks(ticks(), ticks());
    Dimension size = Frame.fit(chart, ticks, 1);
    chart.addAnnotation(new Layer(this::paintGrid));
    chart.addAnnotation(new Layer(new CurveLayer(List.of(diagonal))));
    chart.addAnnotation(new Layer((g, screen) -> paintWhiskers(g, screen, dots.look())));
    chart.addAnnotation(new Layer(new CurveLayer(List.of(dots))));
    chart.addAnnotation(new Layer(this::paintLabels));
    chart.addAnnotation(new Layer(ticks));
    return new Figure(caption, chart, size);
  }

  private Curve diagonal() {
    double[] ends = {axes.least(), axes.most()};
    Look look = Look.of(SeriesRole.NOISY).slim();
    return new Curve("as claimed", ends, ends, look, SeriesStyle.LINE);
  }

  private Curve dots() {
    return new Curve(
        series,
        points.stream().mapToDouble(p -> shown(p.claimed())).toArray(),
        points.stream().mapToDouble(p -> shown(p.found())).toArray(),
        new Look(Look.of(SeriesRole.ORIGINAL).colour(), Ink.round(DOT), 1),
        SeriesStyle.POINTS);
  }

  private double shown(double value) {
    return Math.max(axes.least(), Math.min(axes.most(), value));
  }

  private List<Double> places() {
    double step = Steps.step(axes.most() - axes.least(), PARTS);
    return Steps.multiples(axes.least(), axes.most(), step);
  }

  private List<Ticks.Tick> ticks() {
    return places().stream().map(place -> Ticks.Tick.of(place, place)).toList();
  }

  private void paintGrid(Graphics2D g, Screen screen) {
    Rectangle2D plot = screen.plot();
    g.setStroke(Ink.HAIRLINE);
    g.setColor(Ink.GRID);
    for (double place : places()) {
      double x = Paths.rounded(screen.x(place));
      double y = Paths.rounded(screen.y(place));
      g.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
      g.draw(new Line2D.Double(plot.getX(), y, plot.getMaxX(), y));
    }
  }

  private void paintWhiskers(Graphics2D g, Screen screen, Look look) {
    g.setColor(look.colour());
    g.setStroke(Ink.round(1));
    for (AgreementPoint point : points) {
      if (point.high() > point.low()) {
        double x = Paths.rounded(screen.x(shown(point.claimed())));
        double low = Paths.rounded(screen.y(shown(point.low())));
        double high = Paths.rounded(screen.y(shown(point.high())));
        g.draw(new Line2D.Double(x, low, x, high));
      }
    }
  }

  private void paintLabels(Graphics2D g, Screen screen) {
    List<Rectangle2D> taken = new ArrayList<>();
    for (AgreementPoint point : points) {
      if (!point.label().isEmpty()) {
        paintLabel(g, screen, point, taken);
      }
    }
  }

  private void paintLabel(
      Graphics2D g, Screen screen, AgreementPoint point, List<Rectangle2D> taken) {
    Text text = new Text(point.label(), Ink.RING, Ink.TEXT);
    double right = screen.x(shown(point.claimed())) - LABEL_GAP;
    double y = screen.y(shown(point.found()));
    double height = Ink.RING.getSize2D();
    Rectangle2D box =
        new Rectangle2D.Double(right - text.width(), y - height / 2, text.width(), height);
    if (taken.stream().noneMatch(box::intersects)) {
      text.draw(g, right, y, 1, 0.5);
      taken.add(box);
    }
  }
}
