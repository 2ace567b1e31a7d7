package simbad.blindworld.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;

/** Way-points round, past and towards an obstacle. The kinds differ by how many they are. */
class RoutesTest {

  private static final double NEAR = 1e-9;
  private static final double REACH_M = 2;
  private static final double RADIUS_M = 0.1;
  private static final Point CENTRE = new Point(0.5, -0.25);
  private static final int ROUND = 36;
  private static final int PAST = 2;
  private static final int TOWARDS = 3;
  private static final int TO_AND_FRO = 10;
  private static final int ANYWHERE = 5;

  private static Scene scene(double reachM) {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 4, 0.15, 343, 0.01, 0, 0, 1e-6, 0.1);
    List<Point> outline =
        List.of(new Point(RADIUS_M, 0), new Point(0, RADIUS_M), new Point(-RADIUS_M, 0));
    return new Scene(
        5, sensor, List.of(new Obstacle("o", CENTRE, 0, outline, Shadow.uniform(reachM))));
  }

  /** Some hundred routes, by their number of points. */
  private static List<List<Point>> routes(int size, double reachM) {
    Map<Integer, List<List<Point>>> bySize = new HashMap<>();
    Routes routes = new Routes(scene(reachM), new Chance(5));
    for (int i = 0; i < 400; i++) {
      List<Point> route = routes.next();
      bySize.computeIfAbsent(route.size(), n -> new ArrayList<>()).add(route);
    }
    assertEquals(5, bySize.size());
    return Objects.requireNonNull(bySize.get(size));
  }

  private static double away(Point point) {
    return Math.hypot(point.xM() - CENTRE.xM(), point.zM() - CENTRE.zM());
  }

  /** Counter-clockwise, z being down the page. */
  private static double direction(Point point) {
    return Math.atan2(CENTRE.zM() - point.zM(), point.xM() - CENTRE.xM());
  }

  private static double turn(Point from, Point to) {
    return Math.IEEEremainder(direction(to) - direction(from), 2 * Math.PI);
  }

  private static void assertWithin(double least, double most, double value) {
    assertTrue(value >= least - NEAR && value <= most + NEAR, least + " " + value + " " + most);
  }

  /**
   * Both ways round, a sixteenth of half a turn at a time, narrower or wider by the same factor.
   */
  @Test
  void round_isASpiral() {
    int left = 0;
    List<List<Point>> all = routes(ROUND, REACH_M);
    for (List<Point> route : all) {
      double turn = turn(route.get(0), route.get(1));
      double growth = away(route.get(1)) / away(route.get(0));
      assertEquals(Math.PI / 16, Math.abs(turn), NEAR);
      assertWithin(0.97, 1.03, growth);
      assertWithin(0.25 * REACH_M, 1.05 * REACH_M, away(route.get(0)));
      for (int k = 1; k < route.size(); k++) {
        assertEquals(turn, turn(route.get(k - 1), route.get(k)), NEAR);
        assertEquals(growth, away(route.get(k)) / away(route.get(k - 1)), NEAR);
      }
      left += turn > 0 ? 1 : 0;
    }
    assertWithin(0.3 * all.size(), 0.7 * all.size(), left);
    // Never nearer than 0.3 m, and of what is heard very far 3 m count.
    routes(ROUND, 0.2).forEach(route -> assertEquals(0.3, away(route.get(0)), NEAR));
    routes(ROUND, 99).forEach(route -> assertWithin(0.75, 3.15, away(route.get(0))));
  }

  /** A straight line that misses the obstacle by 0.2 to 1.3 m, which is half way. */
  @Test
  void past_isAStraightLine() {
    for (List<Point> route : routes(PAST, REACH_M)) {
      Point a = route.get(0);
      Point b = route.get(1);
      Point foot = new Point((a.xM() + b.xM()) / 2, (a.zM() + b.zM()) / 2);
      assertWithin(0.2, 1.3, away(foot));
      double across =
          (b.xM() - a.xM()) * (foot.xM() - CENTRE.xM())
              + (b.zM() - a.zM()) * (foot.zM() - CENTRE.zM());
      assertEquals(0, across, NEAR);
      double half = Math.hypot(b.xM() - a.xM(), b.zM() - a.zM()) / 2;
      assertWithin(0.6 * REACH_M, 1.1 * REACH_M, half);
    }
  }

  @Test
  void towards_comesNearAndGoesBackAnotherWay() {
    for (List<Point> route : routes(TOWARDS, REACH_M)) {
      double reach = away(route.get(0));
      assertWithin(0.7 * REACH_M, 1.15 * REACH_M, reach);
      assertWithin(RADIUS_M + 0.15, RADIUS_M + 0.4, away(route.get(1)));
      assertEquals(0, turn(route.get(0), route.get(1)), NEAR);
      assertEquals(reach, away(route.get(2)), NEAR);
      assertWithin(0.3, 1.2, turn(route.get(0), route.get(2)));
    }
    routes(TOWARDS, 0.2).forEach(route -> assertEquals(0.8, away(route.get(0)), NEAR));
  }

  /** Five lanes of one width, each nearer by 0.17 of the reach, begun where the last one ended. */
  @Test
  void toAndFro_isInLanes() {
    for (List<Point> route : routes(TO_AND_FRO, REACH_M)) {
      double wide = 2 * REACH_M * Math.tan(turn(route.get(0), route.get(1)) / 2);
      assertWithin(0.6, 1.6, wide);
      for (int lane = 0; lane < 5; lane++) {
        Point from = route.get(2 * lane);
        Point to = route.get(2 * lane + 1);
        double away = REACH_M * (1 - 0.17 * lane);
        assertEquals(away, away(from), NEAR);
        assertEquals(away, away(to), NEAR);
        double side = lane % 2 == 0 ? 1 : -1;
        assertEquals(side * 2 * Math.atan2(wide / 2, away), turn(from, to), NEAR);
      }
      double middle = direction(route.get(0)) + turn(route.get(0), route.get(1)) / 2;
      double second = direction(route.get(2)) + turn(route.get(2), route.get(3)) / 2;
      assertEquals(0, Math.IEEEremainder(second - middle, 2 * Math.PI), NEAR);
    }
  }

  @Test
  void anywhere_isWithinReach() {
    double least = REACH_M;
    double most = 0;
    for (List<Point> route : routes(ANYWHERE, REACH_M)) {
      for (Point point : route) {
        assertWithin(0.35 * REACH_M, REACH_M, away(point));
        least = Math.min(least, away(point));
        most = Math.max(most, away(point));
      }
    }
    // Of some four hundred points the outermost come near to the ends.
    assertWithin(0.35 * REACH_M, 0.38 * REACH_M, least);
    assertWithin(0.97 * REACH_M, REACH_M, most);
  }
}
