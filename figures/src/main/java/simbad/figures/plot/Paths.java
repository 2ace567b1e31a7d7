package simbad.figures.plot;

import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;

/** Paths with few digits: an SVG writes every digit of a coordinate. */
final class Paths {
  private static final double STEPS_PER_POINT = 100;

  private Paths() {}

  /** Rounds to a hundredth of a point. */
  static double rounded(double value) {
    return Math.rint(value * STEPS_PER_POINT) / STEPS_PER_POINT;
  }

  static Path2D rounded(Shape shape) {
    Path2D path = new Path2D.Double(Path2D.WIND_NON_ZERO);
    double[] c = new double[6];
    for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
      append(path, i.currentSegment(c), c);
    }
    return path;
  }

  private static void append(Path2D path, int kind, double[] c) {
    for (int i = 0; i < c.length; i++) {
      c[i] = rounded(c[i]);
    }
    switch (kind) {
      case PathIterator.SEG_MOVETO -> path.moveTo(c[0], c[1]);
      case PathIterator.SEG_LINETO -> path.lineTo(c[0], c[1]);
      case PathIterator.SEG_QUADTO -> path.quadTo(c[0], c[1], c[2], c[3]);
      case PathIterator.SEG_CUBICTO -> path.curveTo(c[0], c[1], c[2], c[3], c[4], c[5]);
      default -> path.closePath();
    }
  }
}
