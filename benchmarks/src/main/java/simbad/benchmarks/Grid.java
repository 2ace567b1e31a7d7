package simbad.benchmarks;

import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;

/**
 * A square grid of posts with robots in the cells between them: the arrangement in which the speed
 * of the original Simbad was measured. More robots than cells stand in rings round posts that are
 * twice as far apart.
 */
final class Grid {
  /** From post to post along both axes, where every robot has a cell of its own. */
  static final double PITCH_M = 2.5;

  /**
   * Robots of 0.3 m radius that drive round their circles in step round one post: 1.65 m from each
   * other, 0.4 m and more from a post of 0.6 m.
   */
  private static final int RING = 5;

  private static final double RING_RADIUS_M = 1.4;

  private final int columns;
  private final int cellsAlong;
  private final int robots;
  private final boolean inRings;

  /**
   * Creates a grid.
   *
   * @param posts how many, row by row; at least 1
   * @param robots how many; at most 5 for each post, or as many as there are cells
   */
  Grid(int posts, int robots) {
    columns = (int) Math.ceil(Math.sqrt(posts));
    // Odd, so that there is a middle cell: a single robot stands there, posts all round.
    cellsAlong = Math.max(1, (columns - 2) | 1);
    this.robots = robots;
    int cells = cellsAlong * cellsAlong;
    inRings = robots > cells;
    int most = Math.max(cells, RING * posts);
    if (robots > most) {
      throw new IllegalArgumentException("robots = " + robots + " is not in [1, " + most + "]");
    }
  }

  /** Where a post stands. */
  Point post(int index) {
    double pitchM = inRings ? 2 * PITCH_M : PITCH_M;
    return new Point(pitchM * (index % columns), pitchM * Math.floorDiv(index, columns));
  }

  /** The middle of a robot's circle; robots spread over the grid. */
  Point cell(int robot) {
    if (inRings) {
      Point post = post(robot / RING);
      double angle = (robot % RING + 0.625) * Angles.TURN_RAD / RING;
      return new Point(
          post.xM() + RING_RADIUS_M * Math.sin(angle), post.zM() + RING_RADIUS_M * Math.cos(angle));
    }
    int cell = (2 * robot + 1) * cellsAlong * cellsAlong / (2 * robots);
    return new Point(
        PITCH_M * (cell % cellsAlong + 0.5), PITCH_M * (Math.floorDiv(cell, cellsAlong) + 0.5));
  }
}
