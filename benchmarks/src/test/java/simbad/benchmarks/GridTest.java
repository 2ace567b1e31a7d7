package simbad.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.frame.Point;

class GridTest {
  private static double distanceM(Point a, Point b) {
    return Math.hypot(a.xM() - b.xM(), a.zM() - b.zM());
  }

  @Test
  void posts_standRowByRow() {
    Grid grid = new Grid(10);
    assertEquals(new Point(0, 0), grid.post(0));
    assertEquals(new Point(7.5, 0), grid.post(3));
    assertEquals(new Point(2.5, 5), grid.post(9));
  }

  /** Half the diagonal of a cell. */
  @ParameterizedTest
  @ValueSource(ints = {1, 10, 100, 500})
  void cell_ofOneRobot_hasAPostAtItsCorner(int posts) {
    Grid grid = new Grid(posts);
    double nearest =
        IntStream.range(0, posts)
            .mapToDouble(i -> distanceM(grid.post(i), grid.cell(0, 1)))
            .min()
            .orElseThrow();
    assertEquals(Grid.PITCH_M / Math.sqrt(2), nearest, 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"100, 1", "100, 10", "100, 50", "100, 81", "10, 9"})
  void cells_ofSeveralRobots_differ(int posts, int robots) {
    Grid grid = new Grid(posts);
    long different =
        IntStream.range(0, robots)
            .mapToObj(robot -> grid.cell(robot, robots))
            .collect(Collectors.toSet())
            .size();
    assertEquals(robots, different);
  }

  @Test
  void cell_moreRobotsThanCells_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Grid(10).cell(0, 10));
  }
}
