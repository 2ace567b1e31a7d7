package simbad.gap.slice;

import simbad.sonar.ping.Geometry;

/** The obstacle that a ping belongs to. */
public final class Nearest {
  private Nearest() {}

  /**
   * Finds the obstacle that is nearest in the cone; where none is in the cone, the one whose centre
   * is nearest.
   *
   * @param geometry of the log
   * @param ping of the log
   * @return index of the obstacle; 0 where there is none
   */
  public static int of(Geometry geometry, int ping) {
    int first = ping * geometry.obstacles();
    int best = 0;
    for (int other = 1; other < geometry.obstacles(); other++) {
      int here = first + best;
      int there = first + other;
      boolean nearer = geometry.nearestM(there) < geometry.nearestM(here);
      boolean unseen = geometry.nearestM(here) == Double.POSITIVE_INFINITY;
      boolean closer = geometry.centreDistanceM(there) < geometry.centreDistanceM(here);
      if (nearer || (unseen && closer)) {
        best = other;
      }
    }
    return best;
  }
}
