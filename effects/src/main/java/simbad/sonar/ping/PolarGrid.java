package simbad.sonar.ping;

import java.util.Arrays;
import simbad.sonar.frame.Angles;

/** Even bearings all round, and some distances, between which a value is straight. Immutable. */
final class PolarGrid {
  /** Metres to the origin; constant before and behind. */
  private static final double[] DISTANCE_M = {
    0.1, 0.14, 0.2, 0.28, 0.4, 0.56, 0.8, 1.13, 1.6, 2.26, 3.2, 4.53
  };

  private final int bearings;

  /**
   * Makes one.
   *
   * @param bearings how many, the first at 0
   */
  PolarGrid(int bearings) {
    this.bearings = bearings;
  }

  /** A value at a bearing and a distance of the grid, by their numbers. */
  @FunctionalInterface
  interface Values {
    double at(int bearing, int distance);
  }

  /** Returns the distances, rising, metres. */
  static double[] distancesM() {
    return DISTANCE_M.clone();
  }

  /** Returns a distance by its number, metres. */
  double distanceM(int distance) {
    return DISTANCE_M[distance];
  }

  /** Returns the greatest distance, metres. */
  double furthestM() {
    return DISTANCE_M[DISTANCE_M.length - 1];
  }

  /** Returns a bearing by its number, radians. */
  double bearingRad(int bearing) {
    return bearing * Angles.TURN_RAD / bearings;
  }

  /** Returns the number of a bearing and a distance among all. */
  int cell(int bearing, int distance) {
    return bearing * DISTANCE_M.length + distance;
  }

  /** Returns values of all cells that are not known yet. */
  double[] unknown() {
    double[] values = new double[bearings * DISTANCE_M.length];
    Arrays.fill(values, Double.NaN);
    return values;
  }

  /**
   * Returns a value, straight over the bearing and over the distance.
   *
   * @param values of the grid
   * @param bearingRad in [0, 2 pi]
   * @param distanceM positive
   */
  double at(Values values, double bearingRad, double distanceM) {
    double turn = bearingRad / Angles.TURN_RAD * bearings;
    int here = (int) turn % bearings;
    int next = (here + 1) % bearings;
    double share = turn - (int) turn;
    int near = 0;
    while (near < DISTANCE_M.length - 2 && distanceM > DISTANCE_M[near + 1]) {
      near++;
    }
    double way = (distanceM - DISTANCE_M[near]) / (DISTANCE_M[near + 1] - DISTANCE_M[near]);
    double first = between(values.at(here, near), values.at(next, near), share);
    double second = between(values.at(here, near + 1), values.at(next, near + 1), share);
    return between(first, second, Math.max(0, Math.min(1, way)));
  }

  private static double between(double from, double to, double share) {
    return from + share * (to - from);
  }
}
