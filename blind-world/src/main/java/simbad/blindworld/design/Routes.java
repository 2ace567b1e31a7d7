package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Scene;

/** Ways to drive: round an obstacle, past it, towards it and back, to and fro, anywhere. */
final class Routes {

  private final Scene scene;
  private final Chance random;

  Routes(Scene scene, Chance random) {
    this.scene = scene;
    this.random = random;
  }

  /** The next way-points, at least two. */
  List<Point> next() {
    Obstacle goal = scene.obstacles().get(random.nextInt(scene.obstacles().size()));
    return switch (random.nextInt(5)) {
      case 0 -> round(goal);
      case 1 -> past(goal);
      case 2 -> towards(goal);
      case 3 -> toAndFro(goal);
      default -> anywhere(goal);
    };
  }

  private double reachM(Obstacle obstacle) {
    return Math.min(3, obstacle.shadow().greatestM());
  }

  private static Point at(Obstacle centre, double direction, double radiusM) {
    return new Point(
        centre.place().xM() + radiusM * StrictMath.cos(direction),
        centre.place().zM() - radiusM * StrictMath.sin(direction));
  }

  private List<Point> round(Obstacle goal) {
    double begin = random.nextDouble(0, 2 * Math.PI);
    double way = random.nextBoolean() ? 1 : -1;
    double radius = Math.max(0.3, reachM(goal) * random.nextDouble(0.25, 1.05));
    double growth = random.nextDouble(0.97, 1.03);
    List<Point> points = new ArrayList<>();
    for (int k = 0; k < 36; k++) {
      points.add(at(goal, begin + way * k * Math.PI / 16, radius * StrictMath.pow(growth, k)));
    }
    return points;
  }

  private List<Point> past(Obstacle goal) {
    double direction = random.nextDouble(0, 2 * Math.PI);
    double miss = random.nextDouble(0.2, 1.3);
    double reach = reachM(goal) * random.nextDouble(0.6, 1.1);
    Point foot = at(goal, direction, miss);
    double dx = reach * StrictMath.sin(direction);
    double dz = reach * StrictMath.cos(direction);
    return List.of(
        new Point(foot.xM() - dx, foot.zM() - dz), new Point(foot.xM() + dx, foot.zM() + dz));
  }

  private List<Point> towards(Obstacle goal) {
    double direction = random.nextDouble(0, 2 * Math.PI);
    double reach = Math.max(0.8, reachM(goal) * random.nextDouble(0.7, 1.15));
    double near = goal.radiusM() + random.nextDouble(0.15, 0.4);
    return List.of(
        at(goal, direction, reach),
        at(goal, direction, near),
        at(goal, direction + random.nextDouble(0.3, 1.2), reach));
  }

  private List<Point> toAndFro(Obstacle goal) {
    double direction = random.nextDouble(0, 2 * Math.PI);
    double wide = random.nextDouble(0.6, 1.6);
    List<Point> points = new ArrayList<>();
    for (int lane = 0; lane < 5; lane++) {
      double away = reachM(goal) * (1 - 0.17 * lane);
      double side = lane % 2 == 0 ? 1 : -1;
      double half = StrictMath.atan2(wide / 2, away);
      points.add(at(goal, direction - side * half, away));
      points.add(at(goal, direction + side * half, away));
    }
    return points;
  }

  private List<Point> anywhere(Obstacle goal) {
    List<Point> points = new ArrayList<>();
    for (int k = 0; k < 5; k++) {
      points.add(
          at(goal, random.nextDouble(0, 2 * Math.PI), random.nextDouble(0.35, 1) * reachM(goal)));
    }
    return points;
  }
}
