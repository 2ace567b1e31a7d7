package simbad.benchmarks;

import simbad.sonar.frame.Point;

/**
 * A square grid of posts with robots in the cells between them: the arrangement in which the speed
 * of the original Simbad was measured.
 */
final class Grid {
  /** From post to post along both axes. */
  static final double PITCH_M = 2.5;

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

  /** The middle of a robot's cell; robots spread over the grid. */
  Point cell(int robot, int robots) {
    int cells = cellsAlong * cellsAlong;
    if (robots > cells) {
      throw new IllegalArgumentException("robots = " + robots + " is not in [1, " + cells + "]");
    }
    int cell = (2 * robot + 1) * cells / (2 * robots);
    return new Point(
        PITCH_M * (cell % cellsAlong + 0.5), PITCH_M * (Math.floorDiv(cell, cellsAlong) + 0.5));
  }
}
