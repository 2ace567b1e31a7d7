package simbad.scattering;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/**
 * The line round a cross-section, cut into straight elements, gone round so that the body lies to
 * the right and the normals point into the air.
 *
 * <p>A section of several bodies has several such lines, one after the other.
 */
final class Boundary {
  /** Towards a corner elements shrink to this share of the middle ones. */
  private static final double CORNER_SHARE = 0.25;

  /** Thin edges count too: a plate's end is where its echo along the plate comes from. */
  private static final int LEAST_PER_EDGE = 4;

  private final double[] fromX;
  private final double[] fromZ;
  private final double[] toX;
  private final double[] toZ;

  private Boundary(List<Point> from, List<Point> to) {
    fromX = from.stream().mapToDouble(Point::xM).toArray();
    fromZ = from.stream().mapToDouble(Point::zM).toArray();
    toX = to.stream().mapToDouble(Point::xM).toArray();
    toZ = to.stream().mapToDouble(Point::zM).toArray();
  }

  /**
   * Cuts outlines.
   *
   * @param outlines that cross neither themselves nor each other; either sense of going round
   * @param elementM mean length of an edge's elements, metres, positive
   */
  static Boundary of(List<Outline> outlines, double elementM) {
    List<Point> from = new ArrayList<>();
    List<Point> to = new ArrayList<>();
    for (Outline outline : outlines) {
      List<Point> loop = loop(outline, elementM);
      from.addAll(loop);
      Collections.rotate(loop, -1);
      to.addAll(loop);
    }
    return new Boundary(from, to);
  }

  private static List<Point> loop(Outline outline, double elementM) {
    List<Point> corners = new ArrayList<>(outline.corners());
    // With z down the page a positive area is counter-clockwise there, clockwise in x and z.
    if (outline.signedAreaM2() > 0) {
      Collections.reverse(corners);
    }
    List<Point> nodes = new ArrayList<>();
    for (int i = 0; i < corners.size(); i++) {
      addEdge(corners.get(i), corners.get((i + 1) % corners.size()), elementM, nodes);
    }
    return nodes;
  }

  /** Nodes from one corner up to, not with, the next. */
  private static void addEdge(Point from, Point to, double elementM, List<Point> nodes) {
    double lengthM = from.distanceM(to);
    if (lengthM == 0) {
      return;
    }
    int count = Math.max(LEAST_PER_EDGE, (int) Math.ceil(lengthM / elementM));
    for (int i = 0; i < count; i++) {
      double t = graded(i / (double) count);
      nodes.add(
          new Point(from.xM() + t * (to.xM() - from.xM()), from.zM() + t * (to.zM() - from.zM())));
    }
  }

  /** From 0 to 1, slower at both ends: the pressure bends sharply at a corner. */
  private static double graded(double t) {
    return t - (1 - CORNER_SHARE) * Math.sin(2 * Math.PI * t) / (2 * Math.PI);
  }

  int size() {
    return fromX.length;
  }

  double fromX(int j) {
    return fromX[j];
  }

  double fromZ(int j) {
    return fromZ[j];
  }

  double toX(int j) {
    return toX[j];
  }

  double toZ(int j) {
    return toZ[j];
  }

  double middleX(int j) {
    return (fromX[j] + toX[j]) / 2;
  }

  double middleZ(int j) {
    return (fromZ[j] + toZ[j]) / 2;
  }

  double lengthM(int j) {
    return Math.hypot(toX[j] - fromX[j], toZ[j] - fromZ[j]);
  }

  /** Along the element. */
  double tangentX(int j) {
    return (toX[j] - fromX[j]) / lengthM(j);
  }

  double tangentZ(int j) {
    return (toZ[j] - fromZ[j]) / lengthM(j);
  }
}
