package simbad.studio;

import simbad.sonar.check.Checks;

/**
 * Something that a person moved while the world stood still before a step.
 *
 * @param step before which it is moved, at least 0
 * @param thing what it is
 * @param number which of the robots, from 0; 0 for the obstacle
 * @param xM where its middle comes to stand, metres, at most {@value #FARTHEST_M} from 0
 * @param zM the same along z
 * @param turnRad how an obstacle is turned then, counter-clockwise as seen from above; 0 for a
 *     robot
 */
record Move(int step, Thing thing, int number, double xM, double zM, double turnRad) {
  static final double FARTHEST_M = 20;

  /** What can be moved. */
  enum Thing {
    ROBOT,
    OBSTACLE
  }

  Move {
    if (step < 0) {
      throw new IllegalArgumentException("step = " + step + " is below 0");
    }
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.finite("turnRad", turnRad);
  }
}
