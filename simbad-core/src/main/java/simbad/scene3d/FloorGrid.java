package simbad.scene3d;

import javax.media.j3d.GeometryArray;
import javax.media.j3d.LineArray;
import javax.vecmath.Point3d;

/** A faint grid of metres on the floor, by which one sees where the floor ends. */
final class FloorGrid {
  /** So far above the floor that both can be told apart from afar. */
  private static final double LEVEL_M = 0.002;

  /** More lines would be a grey mash. */
  private static final int MOST_LINES = 100;

  private FloorGrid() {}

  /** Returns the lines of the grid of a world of a given side, metres. */
  static LineArray lines(double sideM) {
    int count = Math.max(2, Math.min(MOST_LINES, (int) Math.round(sideM) + 1));
    LineArray lines = new LineArray(4 * count, GeometryArray.COORDINATES);
    double half = sideM / 2;
    for (int i = 0; i < count; i++) {
      double at = -half + sideM * i / (count - 1);
      lines.setCoordinate(4 * i, new Point3d(at, LEVEL_M, -half));
      lines.setCoordinate(4 * i + 1, new Point3d(at, LEVEL_M, half));
      lines.setCoordinate(4 * i + 2, new Point3d(-half, LEVEL_M, at));
      lines.setCoordinate(4 * i + 3, new Point3d(half, LEVEL_M, at));
    }
    return lines;
  }
}
