package simbad.scattering;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/**
 * The line round a cross-section, cut into straight elements, gone round so that the body lies to
 * the right and the normals point into the air.
 *
 * <p>A section of several bodies has several such lines, one after the other.
 */
final class Boundary {
  /** A corner that turns by less is one of a curve's. */
  private static final double SHARP_RAD = Math.toRadians(30);

  private final double[] fromX;
  private final double[] fromZ;
  private final double[] atX;
  private final double[] atZ;
  private final double[] toX;
  private final double[] toZ;
  private final double[] lengthM;
  private final double[] tangentX;
  private final double[] tangentZ;

  private Boundary(List<Point> from, List<Point> at, List<Point> to) {
    fromX = from.stream().mapToDouble(Point::xM).toArray();
    fromZ = from.stream().mapToDouble(Point::zM).toArray();
    atX = at.stream().mapToDouble(Point::xM).toArray();
    atZ = at.stream().mapToDouble(Point::zM).toArray();
    toX = to.stream().mapToDouble(Point::xM).toArray();
    toZ = to.stream().mapToDouble(Point::zM).toArray();
    lengthM = each(j -> Math.hypot(toX[j] - fromX[j], toZ[j] - fromZ[j]));
    tangentX = each(j -> (toX[j] - fromX[j]) / lengthM[j]);
    tangentZ = each(j -> (toZ[j] - fromZ[j]) / lengthM[j]);
  }

  private double[] each(IntToDoubleFunction value) {
    return IntStream.range(0, size()).mapToDouble(value).toArray();
  }

  /**
   * Cuts outlines.
   *
   * @param outlines that cross neither themselves nor each other; either sense of going round
   * @param elementM greatest length of an element, metres, positive
   */
  static Boundary of(List<Outline> outlines, double elementM) {
    List<Point> from = new ArrayList<>();
    List<Point> at = new ArrayList<>();
    List<Point> to = new ArrayList<>();
    for (Outline outline : outlines) {
      List<Point> loop = new ArrayList<>();
      addLoop(corners(outline), elementM, loop, at);
      from.addAll(loop);
      Collections.rotate(loop, -1);
      to.addAll(loop);
    }
    return new Boundary(from, at, to);
  }

  /** Without corners that stand twice, clockwise in x and z. */
  private static List<Point> corners(Outline outline) {
    List<Point> corners = new ArrayList<>();
    for (Point corner : outline.corners()) {
      if (corners.isEmpty() || !corner.equals(corners.get(corners.size() - 1))) {
        corners.add(corner);
      }
    }
    if (corners.get(0).equals(corners.get(corners.size() - 1))) {
      corners.remove(corners.size() - 1);
    }
    // With z down the page a positive area is counter-clockwise there, clockwise in x and z.
    if (outline.signedAreaM2() > 0) {
      Collections.reverse(corners);
    }
    return corners;
  }

  private static void addLoop(
      List<Point> corners, double elementM, List<Point> nodes, List<Point> at) {
    int n = corners.size();
    for (int i = 0; i < n; i++) {
      Point from = corners.get(i);
      Point to = corners.get((i + 1) % n);
      EdgeCut cut =
          new EdgeCut(
              from.distanceM(to),
              elementM,
              isSharp(corners.get((i + n - 1) % n), from, to),
              isSharp(from, to, corners.get((i + 2) % n)));
      for (int e = 0; e < cut.count(); e++) {
        nodes.add(between(from, to, cut.atM(e) / cut.lengthM()));
        at.add(between(from, to, cut.atM(e + 0.5) / cut.lengthM()));
      }
    }
  }

  private static boolean isSharp(Point before, Point corner, Point after) {
    double inX = corner.xM() - before.xM();
    double inZ = corner.zM() - before.zM();
    double outX = after.xM() - corner.xM();
    double outZ = after.zM() - corner.zM();
    double turnRad = Math.atan2(inX * outZ - inZ * outX, inX * outX + inZ * outZ);
    return Math.abs(turnRad) > SHARP_RAD;
  }

  private static Point between(Point from, Point to, double share) {
    return new Point(
        from.xM() + share * (to.xM() - from.xM()), from.zM() + share * (to.zM() - from.zM()));
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

  /**
   * Where the equation of an element holds. Half-way by {@link EdgeCut}'s count of elements: there,
   * and not at the middle of an element that has a longer neighbour and a shorter one, are
   * differences of constant pressures derivatives of the second order.
   */
  double collocationX(int i) {
    return atX[i];
  }

  double collocationZ(int i) {
    return atZ[i];
  }

  double middleX(int j) {
    return (fromX[j] + toX[j]) / 2;
  }

  double middleZ(int j) {
    return (fromZ[j] + toZ[j]) / 2;
  }

  double lengthM(int j) {
    return lengthM[j];
  }

  /** Along the element. */
  double tangentX(int j) {
    return tangentX[j];
  }

  double tangentZ(int j) {
    return tangentZ[j];
  }
}
