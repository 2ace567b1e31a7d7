package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Svg.Spot;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.sensing.ReadingRow;

/** Where the pings of the next experiment are sent from and to, seen from above. */
final class PosePlan {
  private static final double ARROW = 11;

  private PosePlan() {}

  static Html of(List<ReadingRow> poses, Scene scene) {
    List<Point> points = new ArrayList<>();
    poses.forEach(row -> points.add(row.pose().position()));
    scene.obstacles().forEach(o -> points.addAll(o.worldOutline().corners()));
    GroundPlan plan = GroundPlan.around("Poses of the next experiment, seen from above", points);
    scene.obstacles().forEach(o -> outline(plan, o.worldOutline().corners()));
    poses.forEach(row -> arrow(plan, row.pose()));
    return plan.svg().html();
  }

  private static void outline(GroundPlan plan, List<Point> corners) {
    plan.svg().path(plan.path(corners) + "Z", "body", "");
    plan.svg().circle(plan.spot(corners.get(0)), 3, "dot", "");
  }

  private static void arrow(GroundPlan plan, Pose pose) {
    Spot from = plan.spot(pose.position());
    double heading = pose.heading().radians();
    String tip =
        "x "
            + Numbers.fixed(pose.position().xM(), 2)
            + " m, z "
            + Numbers.fixed(pose.position().zM(), 2)
            + " m, heading "
            + Numbers.fixed(Math.toDegrees(heading), 0)
            + "°";
    plan.svg().circle(from, 2.2, "ping", tip);
    Spot to = new Spot(from.x() + ARROW * Math.cos(heading), from.y() - ARROW * Math.sin(heading));
    plan.svg().line(from, to, "aim");
  }
}
