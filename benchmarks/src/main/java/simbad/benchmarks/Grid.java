package simbad.benchmarks;

import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;

/**
 * A square grid of posts with robots in the cells between them: the arrangement in which the speed
 * of the original Simbad was measured.
 */
final class Grid {
  /** From post to post along both axes. */
  static final double PITCH_M = 2.5;

  /**
   * Robots of 0.3 m radius that share a cell and drive round circles in step: as many and as far
   * apart as leave 5 cm between them, and between them and the boxes.
   */
  private static final int RING = 5;

  private static final double RING_RADIUS_M = 0.553;

  private final int columns;
  private final int cellsAlong;

  /**
   * Creates a grid.
   *
   * @param posts how many, row by row; at least 1
   */
  Grid(int posts) {
    columns = (int) Math.ceil(Math.sqrt(posts));
    // Odd, so that there is a middle cell: a single robot stands there, posts all round.
    cellsAlong = Math.max(1, (columns - 2) | 1);
  }

  /** Where a post stands. */
  Point post(int index) {
    return new Point(PITCH_M * (index % columns), PITCH_M * Math.floorDiv(index, columns));
  }

  /**
   * The middle of a robot's circle. Robots spread over the cells; if there are more robots than
   * those, rings of up to 5 stand in as many cells as there are posts.
   */
  Point cell(int robot, int robots) {
    int cells = cellsAlong * cellsAlong;
    if (robots <= cells) {
      return middle((2 * robot + 1) * cells / (2 * robots), cellsAlong);
    }
    if (robots > RING * columns * columns) {
      throw new IllegalArgumentException(
          "robots = " + robots + " is not in [1, " + RING * columns * columns + "]");
    }
    Point middle = middle(robot / RING, columns);
    double angle = robot % RING * Angles.TURN_RAD / RING;
    return new Point(
        middle.xM() + RING_RADIUS_M * Math.sin(angle),
        middle.zM() + RING_RADIUS_M * Math.cos(angle));
  }

  private static Point middle(int cell, int along) {
    return new Point(PITCH_M * (cell % along + 0.5), PITCH_M * (Math.floorDiv(cell, along) + 0.5));
  }
}
