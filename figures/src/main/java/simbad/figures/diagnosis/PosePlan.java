package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.sensing.ReadingRow;

/** Where the pings of the next experiment are sent from and to, seen from above. */
final class PosePlan {
  private static final int SIZE = 420;
  private static final int PLOT = 358;
  private static final int LEFT = 54;
  private static final int TOP = 8;
  private static final double ARROW = 11;
  private static final double MARGIN = 0.06;

  private final AxisScale x;
  private final AxisScale z;
  private final Svg svg = new Svg(SIZE, SIZE, "Poses of the next experiment, seen from above");

  private PosePlan(AxisScale x, AxisScale z) {
    this.x = x;
    this.z = z;
  }

  static Html of(List<ReadingRow> poses, Scene scene) {
    List<Point> points = new ArrayList<>();
    poses.forEach(row -> points.add(row.pose().position()));
    scene.obstacles().forEach(o -> points.addAll(o.worldOutline().corners()));
    PosePlan plan = around(points);
    plan.axes();
    scene.obstacles().forEach(o -> plan.outline(o.worldOutline().corners()));
    poses.forEach(row -> plan.arrow(row.pose()));
    return plan.svg.html();
  }

  /** One scale for both axes, so that angles are true. */
  private static PosePlan around(List<Point> points) {
    double lowX = points.stream().mapToDouble(Point::xM).min().orElse(0);
    double highX = points.stream().mapToDouble(Point::xM).max().orElse(1);
    double lowZ = points.stream().mapToDouble(Point::zM).min().orElse(0);
    double highZ = points.stream().mapToDouble(Point::zM).max().orElse(1);
    double side = Math.max(0.1, Math.max(highX - lowX, highZ - lowZ)) * (1 + 2 * MARGIN);
    double step = AxisScale.roundStep(side / 5);
    return new PosePlan(centred(lowX, highX, side, step), centred(lowZ, highZ, side, step));
  }

  private static AxisScale centred(double low, double high, double side, double step) {
    double middle = (low + high) / 2;
    return new AxisScale(middle - side / 2, middle + side / 2, step);
  }

  private void axes() {
    for (double tick = first(x); tick <= x.high(); tick += x.step()) {
      svg.line(new Spot(xOf(tick), TOP), new Spot(xOf(tick), TOP + PLOT), "grid");
      svg.words(new Spot(xOf(tick), TOP + PLOT + 16), "middle", x.label(tick));
    }
    for (double tick = first(z); tick <= z.high(); tick += z.step()) {
      svg.line(new Spot(LEFT, zOf(tick)), new Spot(LEFT + PLOT, zOf(tick)), "grid");
      svg.words(new Spot(LEFT - 5, zOf(tick) + 4), "end", z.label(tick));
    }
    svg.words(new Spot(LEFT + PLOT / 2.0, SIZE - 8), "middle", "x, m");
    svg.wordsUpward(new Spot(16, TOP + PLOT / 2.0), "z, m (down the page)");
  }

  private static double first(AxisScale axis) {
    return Math.ceil(axis.low() / axis.step()) * axis.step();
  }

  private void outline(List<Point> corners) {
    StringBuilder path = new StringBuilder();
    for (Point corner : corners) {
      path.append(path.isEmpty() ? "M" : "L").append(Svg.at(xOf(corner.xM()), zOf(corner.zM())));
    }
    svg.path(path + "Z", "body", "");
    svg.circle(new Spot(xOf(corners.get(0).xM()), zOf(corners.get(0).zM())), 3, "dot", "");
  }

  private void arrow(Pose pose) {
    double px = xOf(pose.position().xM());
    double pz = zOf(pose.position().zM());
    double heading = pose.heading().radians();
    String tip =
        "x "
            + Numbers.fixed(pose.position().xM(), 2)
            + " m, z "
            + Numbers.fixed(pose.position().zM(), 2)
            + " m, heading "
            + Numbers.fixed(Math.toDegrees(heading), 0)
            + "°";
    svg.circle(new Spot(px, pz), 2.2, "ping", tip);
    svg.line(
        new Spot(px, pz),
        new Spot(px + ARROW * Math.cos(heading), pz - ARROW * Math.sin(heading)),
        "aim");
  }

  private double xOf(double value) {
    return LEFT + x.share(value) * PLOT;
  }

  private double zOf(double value) {
    return TOP + z.share(value) * PLOT;
  }
}
