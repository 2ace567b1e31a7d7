package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Svg;
import simbad.sonar.frame.Point;

/** A piece of ground seen from above, one scale for both axes, so that angles are true. */
final class GroundPlan {
  private static final int SIZE = 420;
  private static final int PLOT = 342;
  private static final int LEFT = 70;
  private static final int TOP = 8;
  private static final double MARGIN = 0.06;

  private final AxisScale x;
  private final AxisScale z;
  private final Svg svg;

  private GroundPlan(Svg svg, AxisScale x, AxisScale z) {
    this.svg = svg;
    this.x = x;
    this.z = z;
  }

  /** Lays a plan out, with its axes, in which all points have a place. */
  static GroundPlan around(String title, List<Point> points) {
    double lowX = points.stream().mapToDouble(Point::xM).min().orElse(0);
    double highX = points.stream().mapToDouble(Point::xM).max().orElse(1);
    double lowZ = points.stream().mapToDouble(Point::zM).min().orElse(0);
    double highZ = points.stream().mapToDouble(Point::zM).max().orElse(1);
    double side = Math.max(0.1, Math.max(highX - lowX, highZ - lowZ)) * (1 + 2 * MARGIN);
    double step = AxisScale.roundStep(side / 5);
    GroundPlan plan =
        new GroundPlan(
            new Svg(SIZE, SIZE, title),
            centred(lowX, highX, side, step),
            centred(lowZ, highZ, side, step));
    plan.axes();
    return plan;
  }

  private static AxisScale centred(double low, double high, double side, double step) {
    double middle = (low + high) / 2;
    return new AxisScale(middle - side / 2, middle + side / 2, step);
  }

  private void axes() {
    for (double tick = first(x); tick <= x.high(); tick += x.step()) {
      svg.line(new Svg.Spot(xOf(tick), TOP), new Svg.Spot(xOf(tick), TOP + PLOT), "grid");
      svg.words(new Svg.Spot(xOf(tick), TOP + PLOT + 16), "middle", x.label(tick));
    }
    for (double tick = first(z); tick <= z.high(); tick += z.step()) {
      svg.line(new Svg.Spot(LEFT, zOf(tick)), new Svg.Spot(LEFT + PLOT, zOf(tick)), "grid");
      svg.words(new Svg.Spot(LEFT - 5, zOf(tick) + 4), "end", z.label(tick));
    }
    svg.words(new Svg.Spot(LEFT + PLOT / 2.0, SIZE - 8), "middle", "x, m");
    svg.wordsUpward(new Svg.Spot(16, TOP + PLOT / 2.0), "z, m (down the page)");
  }

  private static double first(AxisScale axis) {
    return Math.ceil(axis.low() / axis.step()) * axis.step();
  }

  /** Returns what it is drawn into. */
  Svg svg() {
    return svg;
  }

  /** Returns where a point lies in the drawing. */
  Svg.Spot spot(Point point) {
    return new Svg.Spot(xOf(point.xM()), zOf(point.zM()));
  }

  /** Returns the path through some points. */
  String path(List<Point> points) {
    StringBuilder path = new StringBuilder();
    for (Point point : points) {
      path.append(path.isEmpty() ? "M" : "L").append(Svg.at(xOf(point.xM()), zOf(point.zM())));
    }
    return path.toString();
  }

  private double xOf(double value) {
    return LEFT + x.share(value) * PLOT;
  }

  private double zOf(double value) {
    return TOP + z.share(value) * PLOT;
  }
}
