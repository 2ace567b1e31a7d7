package simbad.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.frame.Point;

class GridTest {
  private static final double ROBOT_RADIUS_M = 0.3;

  private static double distanceM(Point a, Point b) {
    return Math.hypot(a.xM() - b.xM(), a.zM() - b.zM());
  }

  @Test
  void posts_standRowByRow() {
    Grid grid = new Grid(10, 1);
    assertEquals(new Point(0, 0), grid.post(0));
    assertEquals(new Point(7.5, 0), grid.post(3));
    assertEquals(new Point(2.5, 5), grid.post(9));
  }

  /** Half the diagonal of a cell. */
  @ParameterizedTest
  @ValueSource(ints = {1, 10, 100, 500})
  void cell_ofOneRobot_hasAPostAtItsCorner(int posts) {
    Grid grid = new Grid(posts, 1);
    double nearest =
        IntStream.range(0, posts)
            .mapToDouble(i -> distanceM(grid.post(i), grid.cell(0)))
            .min()
            .orElseThrow();
    assertEquals(Grid.PITCH_M / Math.sqrt(2), nearest, 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"100, 1", "100, 10", "100, 50", "100, 81", "10, 9", "100, 500", "7, 35"})
  void cells_ofSeveralRobots_differ(int posts, int robots) {
    Grid grid = new Grid(posts, robots);
    long different =
        IntStream.range(0, robots)
            .mapToObj(robot -> grid.cell(robot))
            .collect(Collectors.toSet())
            .size();
    assertEquals(robots, different);
  }

  /** All are at the same angle of their circles at any time, so that distances stay. */
  @Test
  void cells_inRings_keepRobotsApartAndClearOfBoxes() {
    Grid grid = new Grid(100, 500);
    for (int i = 0; i < 500; i++) {
      for (int j = 0; j < i; j++) {
        assertTrue(distanceM(grid.cell(i), grid.cell(j)) > 2 * ROBOT_RADIUS_M + 0.3);
      }
      double fromPostM = distanceM(grid.cell(i), grid.post(i / 5));
      double halfDiagonalM = Arena.BOX_M / Math.sqrt(2);
      assertTrue(fromPostM - Circle.RADIUS_M - ROBOT_RADIUS_M > halfDiagonalM);
    }
  }

  @Test
  void grid_moreRobotsThanRoundPosts_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Grid(10, 51));
  }
}
