package simbad.gap.calibrate.level;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/**
 * The turns and mirror images that take an outline to itself, and with it the bearings at which a
 * target answers alike. Bearings are those of {@link LevelForms#BEARINGS}. Immutable.
 */
final class Symmetry {
  /** Of the outline's size: with 6 % false symmetries were found in the shapes that were tried. */
  private static final double TOLERANCE = 0.025;

  private static final int SIZE = LevelForms.BEARINGS;

  /** Of each bearing: the number of its orbit. */
  private final int[] orbit;

  /** Of each orbit: one of its bearings. */
  private final List<Integer> representative = new ArrayList<>();

  /** Images of a bearing b: sign * b + shift, in steps of the grid. */
  private final List<int[]> images = new ArrayList<>();

  private Symmetry(Outline outline) {
    for (int shift = 0; shift < SIZE; shift++) {
      for (int sign = 1; sign >= -1; sign -= 2) {
        if (isSame(outline, sign, shift)) {
          images.add(new int[] {sign, shift});
        }
      }
    }
    orbit = new int[SIZE];
    Arrays.fill(orbit, -1);
    for (int bearing = 0; bearing < SIZE; bearing++) {
      if (orbit[bearing] < 0) {
        follow(bearing, representative.size());
        representative.add(bearing);
      }
    }
  }

  /** Images of images too: within a tolerance the turns are no group. */
  private void follow(int bearing, int number) {
    Deque<Integer> open = new ArrayDeque<>(List.of(bearing));
    orbit[bearing] = number;
    while (!open.isEmpty()) {
      int from = open.remove();
      for (int image = 0; image < images.size(); image++) {
        int to = image(from, image);
        if (orbit[to] < 0) {
          orbit[to] = number;
          open.add(to);
        }
      }
    }
  }

  /** Finds those of an outline. */
  static Symmetry of(Outline outline) {
    return new Symmetry(outline);
  }

  /** There and back: of two polygons each has to lie near the other. */
  private static boolean isSame(Outline outline, int sign, int shift) {
    double tolerance = TOLERANCE * outline.reachM(0, 0);
    double turn = shift * Angles.TURN_RAD / SIZE;
    return isNear(outline, sign, turn, tolerance)
        && (sign < 0 || isNear(outline, sign, -turn, tolerance));
  }

  private static boolean isNear(Outline outline, int sign, double turn, double tolerance) {
    int from = outline.size() - 1;
    for (int to = 0; to < outline.size(); to++) {
      double midX = (outline.xM(from) + outline.xM(to)) / 2;
      double midZ = (outline.zM(from) + outline.zM(to)) / 2;
      Point corner = image(outline.xM(to), outline.zM(to), sign, turn);
      Point middle = image(midX, midZ, sign, turn);
      if (outline.distanceM(corner.xM(), corner.zM()) > tolerance
          || outline.distanceM(middle.xM(), middle.zM()) > tolerance) {
        return false;
      }
      from = to;
    }
    return true;
  }

  private static Point image(double xM, double zM, int sign, double turn) {
    double bearing = sign * Math.atan2(xM, zM) + turn;
    double radius = Math.hypot(xM, zM);
    return new Point(radius * Math.sin(bearing), radius * Math.cos(bearing));
  }

  private int image(int bearing, int index) {
    int[] image = images.get(index);
    return Math.floorMod(image[0] * bearing + image[1], SIZE);
  }

  /** Returns the number of orbits. */
  int orbits() {
    return representative.size();
  }

  /** Returns the orbit of a bearing. */
  int orbit(int bearing) {
    return orbit[bearing];
  }

  /**
   * Returns the sum over all images of what belongs to the step between a bearing of one orbit and
   * one of another.
   *
   * @param orbit number of the one
   * @param other number of the other
   * @param byStep a value for each step round, from 0
   */
  double sum(int orbit, int other, double[] byStep) {
    int from = representative.get(orbit);
    int to = representative.get(other);
    double sum = 0;
    for (int image = 0; image < images.size(); image++) {
      sum += byStep[Math.floorMod(image(to, image) - from, SIZE)];
    }
    return sum;
  }
}
