package simbad.figures.plot;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import org.knowm.xchart.XYChart;
import simbad.sonar.check.Checks;

/**
 * An error in centimetres over a parameter: curves, and marks at single settings. The axis of the
 * error is logarithmic where it spans more than a factor of 20.
 *
 * @param caption title and provenance, both always shown
 * @param parameter title of the axis to the right
 * @param curves at least one, names distinct
 * @param marks may be empty
 */
public record TuningPlot(Caption caption, String parameter, List<Line> curves, List<Line> marks) {
  private static final int WIDTH = 540;
  private static final double ASPECT = 0.6;
  private static final int PARTS = 7;

  /** On both sides, as a share of what the parameter spans: a mark at the end stays whole. */
  private static final double MARGIN = 0.02;

  /** Of the line that the marks' size follows from. */
  private static final float MARK = 5;

  /** Along the legend's line, where its one dot stands. */
  private static final float HALF_WAY = 19;

  /**
   * Points with a name in the legend.
   *
   * @param name not blank
   * @param role fixes the colour
   * @param pattern from 1 to {@link #PATTERNS}, tells curves of one colour apart by width and dash;
   *     0 is the role's own
   * @param points parameter and error in centimetres, along the parameter
   */
  public record Line(String name, SeriesRole role, int pattern, List<Point> points) {
    /** How many patterns there are. */
    public static final int PATTERNS = PlotLook.PATTERNS;

    /** Copies the list. */
    public Line {
      Labels.notBlank("name", name);
      if (pattern < 0 || pattern > PATTERNS) {
        throw new IllegalArgumentException(
            "pattern = " + pattern + " is not in [0, " + PATTERNS + "]");
      }
      points = List.copyOf(points);
    }

    /** One with its role's own looks. */
    public Line(String name, SeriesRole role, List<Point> points) {
      this(name, role, 0, points);
    }
  }

  /**
   * A point.
   *
   * @param parameter value
   * @param errorCm at least 0
   */
  public record Point(double parameter, double errorCm) {
    /** Refuses what is no place. */
    public Point {
      Checks.finite("parameter", parameter);
      Checks.notNegative("errorCm", errorCm);
    }
  }

  /** Copies the lists. */
  public TuningPlot {
    curves = List.copyOf(curves);
    marks = List.copyOf(marks);
    Labels.distinctNames(Stream.concat(curves.stream(), marks.stream()).toList(), Line::name);
  }

  /** Lays the picture out. */
  public PlotFigure figure() {
    ErrorScale scale = ErrorScale.of(all().mapToDouble(Point::errorCm).toArray());
    XYChart chart = Frame.chart(caption, WIDTH, parameter, "mean error |r − T| (cm)");
    chart.getStyler().setYAxisLogarithmic(scale.isLog());
    Frame.range(chart, left(), right(), scale.bottomCm(), scale.topCm());
    List<PlotCurve> lines = curves.stream().map(line -> curve(line, scale, false)).toList();
    List<PlotCurve> dots = marks.stream().map(line -> curve(line, scale, true)).toList();
    Frame.add(chart, lines);
    dots.forEach(dot -> dot.setLineStyle(oneDot(dot.look().dotSize())));
    Frame.add(chart, dots);
    Ticks ticks = ticks(scale);
    Dimension size = Frame.fit(chart, ticks, ASPECT);
    chart.addAnnotation(new PlotLayer((g, screen) -> paintGrid(g, screen, scale)));
    chart.addAnnotation(new PlotLayer(new CurveLayer(lines)));
    chart.addAnnotation(new PlotLayer(new CurveLayer(dots)));
    chart.addAnnotation(new PlotLayer(ticks));
    return new PlotFigure(caption, chart, size);
  }

  /**
   * A dash of no length at the line's begin would be a dot as well: the pattern begins in the gap.
   */
  private static BasicStroke oneDot(float size) {
    float[] dash = {0.01f, 90f};
    return new BasicStroke(
        size, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 4f, dash, dash[1] - HALF_WAY);
  }

  private Stream<Point> all() {
    return Stream.concat(curves.stream(), marks.stream()).flatMap(line -> line.points().stream());
  }

  private double least() {
    return all().mapToDouble(Point::parameter).min().orElse(0);
  }

  private double most() {
    return all().mapToDouble(Point::parameter).max().orElse(1);
  }

  /** Room beside the outermost points; a single place has the room of its own size. */
  private double margin() {
    double span = most() - least();
    return span > 0 ? MARGIN * span : Math.max(Math.abs(most()), MARGIN) / 2;
  }

  /** The data's own range: an axis from 0 would squeeze 1000 to 1010 into a line. */
  private double left() {
    double left = least() - margin();
    return least() >= 0 ? Math.max(0, left) : left;
  }

  private double right() {
    double right = most() + margin();
    return most() <= 0 && least() < 0 ? Math.min(0, right) : right;
  }

  private static PlotCurve curve(Line line, ErrorScale scale, boolean isMark) {
    PlotLook look = PlotLook.of(line.role()).slim().withPattern(line.pattern());
    return new PlotCurve(
        line.name(),
        line.points().stream().mapToDouble(Point::parameter).toArray(),
        line.points().stream().mapToDouble(point -> scale.clamped(point.errorCm())).toArray(),
        isMark ? new PlotLook(look.colour(), PlotInk.round(MARK), look.depth()) : look,
        isMark ? SeriesStyle.POINTS : SeriesStyle.LINE);
  }

  private Ticks ticks(ErrorScale scale) {
    return new Ticks(
        places().stream().map(place -> Ticks.Tick.of(place, place)).toList(),
        scale.ticks().stream().map(cm -> new Ticks.Tick(cm, scale.label(cm))).toList());
  }

  private List<Double> places() {
    return Steps.multiples(left(), right(), Steps.step(right() - left(), PARTS));
  }

  private void paintGrid(Graphics2D g, PlotScreen screen, ErrorScale scale) {
    Rectangle2D plot = screen.plot();
    g.setStroke(PlotInk.HAIRLINE);
    g.setColor(PlotInk.GRID);
    for (double cm : scale.ticks()) {
      double y = Paths.rounded(screen.y(cm));
      g.draw(new Line2D.Double(plot.getX(), y, plot.getMaxX(), y));
    }
    for (double place : places()) {
      double x = Paths.rounded(screen.x(place));
      g.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
    }
  }
}
