package simbad.motion;

/**
 * Displacements along a grid of mean speeds, in the frame of the pose at their start: the chords of
 * the arcs of all steps of the grid, whole or in part.
 */
final class Leg {
  private final Stages stages;
  private final CommandSeries means;
  private final Facing facing = new Facing();
  private double x;
  private double y;
  private double turn;

  Leg(Stages stages, CommandSeries means) {
    this.stages = stages;
    this.means = means;
  }

  /**
   * Returns how far it is from one place of the grid to another.
   *
   * @param from the pose before it, and a share of the step from there
   * @param to the same, not before from
   */
  Displacement between(double from, double to) {
    int first = (int) from;
    int last = (int) to;
    x = 0;
    y = 0;
    turn = 0;
    facing.faceNear(-(from - first) * turnRad(first));
    if (first == last) {
      add(first, to - from);
    } else {
      add(first, 1 - (from - first));
      for (int cell = first + 1; cell < last; cell++) {
        add(cell, 1);
      }
      add(last, to - last);
    }
    return new Displacement(x, y, turn);
  }

  private double turnRad(int cell) {
    return stages.turn(means.turns()[cell + 1], speed(cell)) * Way.STEP_S;
  }

  private double speed(int cell) {
    return stages.speed(means.speeds()[cell + 1], means.turns()[cell + 1]);
  }

  private void add(int cell, double share) {
    double speed = speed(cell);
    double rad = stages.turn(means.turns()[cell + 1], speed) * Way.STEP_S;
    facing.turn(rad);
    double way = share * speed * Way.STEP_S * facing.chord();
    x += way * facing.middleX();
    y += way * facing.middleY();
    turn += share * rad;
  }
}
