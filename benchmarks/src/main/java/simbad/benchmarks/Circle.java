package simbad.benchmarks;

import simbad.kernel.belt.BeltLayout;
import simbad.kernel.geometry.Placement;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A belt's poses on a small circle, laid out beforehand: a belt at one place would let the
 * processor learn its readings by heart.
 */
final class Circle {
  /** Radius of the circle. */
  static final double RADIUS_M = 0.4;

  /** Places on it. */
  static final int PLACES = 256;

  private static final double HEIGHT_M = 0.5;

  private final TransducerPoses[] poses = new TransducerPoses[PLACES];
  private int next;

  Circle(Point centre, BeltLayout layout) {
    for (int i = 0; i < PLACES; i++) {
      double angle = i * Angles.TURN_RAD / PLACES;
      Placement place =
          Placement.at(
              centre.xM() + RADIUS_M * Math.sin(angle),
              HEIGHT_M,
              centre.zM() + RADIUS_M * Math.cos(angle));
      place.turnAboutY(angle);
      poses[i] = new TransducerPoses(layout.size());
      layout.place(place, poses[i]);
    }
  }

  /** The poses at the next place. */
  TransducerPoses step() {
    next = (next + 1) % PLACES;
    return poses[next];
  }
}
