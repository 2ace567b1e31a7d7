package simbad.blindworld.wave;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Point;

/**
 * The cross-section of a target, cut into straight elements of about an eighth of a wave length,
 * each with its normal outwards; and its faces, between which sound may go to and fro.
 */
public final class Outline {

  private static final double ELEMENT_M = 0.0011;

  /** Where elements lie, in the target's own frame. */
  final double[] xM;

  final double[] zM;

  /** Their normals. */
  final double[] normalX;

  final double[] normalZ;

  /** Their lengths, each times the share of sound that it sends back. */
  final double[] lengthM;

  /** Faces of what is hollow, as corner pairs; empty for what is convex. */
  final List<Face> faces;

  final double radiusM;
  private final boolean clockwise;

  /** A face between two corners. */
  record Face(Point from, Point to) {

    double lengthM() {
      return StrictMath.hypot(to.xM() - from.xM(), to.zM() - from.zM());
    }

    /** True when the straight way between two points goes through the face. */
    boolean parts(double aX, double aZ, double bX, double bZ) {
      double fX = to.xM() - from.xM();
      double fZ = to.zM() - from.zM();
      double sideA = fX * (aZ - from.zM()) - fZ * (aX - from.xM());
      double sideB = fX * (bZ - from.zM()) - fZ * (bX - from.xM());
      double wayX = bX - aX;
      double wayZ = bZ - aZ;
      double sideFrom = wayX * (from.zM() - aZ) - wayZ * (from.xM() - aX);
      double sideTo = wayX * (to.zM() - aZ) - wayZ * (to.xM() - aX);
      return sideA * sideB < 0 && sideFrom * sideTo < 0;
    }
  }

  private Outline(List<Point> corners, boolean clockwise, boolean hollow, List<Double> shares) {
    this.clockwise = clockwise;
    List<double[]> elements = new ArrayList<>();
    List<Face> all = new ArrayList<>();
    for (int i = 0; i < corners.size(); i++) {
      Face face = new Face(corners.get(i), corners.get((i + 1) % corners.size()));
      all.add(face);
      cut(face, clockwise, elements, shares.get(i));
    }
    xM = column(elements, 0);
    zM = column(elements, 1);
    normalX = column(elements, 2);
    normalZ = column(elements, 3);
    lengthM = column(elements, 4);
    faces = hollow ? List.copyOf(all) : List.of();
    radiusM =
        corners.stream().mapToDouble(p -> StrictMath.hypot(p.xM(), p.zM())).max().orElseThrow();
  }

  private static double[] column(List<double[]> elements, int which) {
    return elements.stream().mapToDouble(e -> e[which]).toArray();
  }

  /** A polygon of at least three corners, either way round. */
  public static Outline of(List<Point> corners) {
    return covered(corners, corners.stream().map(p -> 1.0).toList());
  }

  /** A polygon each of whose faces sends back a share of the pressure that meets it. */
  public static Outline covered(List<Point> corners, List<Double> shares) {
    shares.forEach(share -> Checks.share("share of sound", share));
    double area = 0;
    boolean left = false;
    boolean right = false;
    for (int i = 0; i < corners.size(); i++) {
      Point a = corners.get(i);
      Point b = corners.get((i + 1) % corners.size());
      Point c = corners.get((i + 2) % corners.size());
      area += a.xM() * b.zM() - b.xM() * a.zM();
      double bend = (b.xM() - a.xM()) * (c.zM() - b.zM()) - (b.zM() - a.zM()) * (c.xM() - b.xM());
      left |= bend > 1e-12;
      right |= bend < -1e-12;
    }
    return new Outline(corners, area < 0, left && right, shares);
  }

  /** A round one. */
  public static Outline round(double radiusM) {
    Checks.positive("radius", radiusM);
    int count = Math.max(24, (int) Math.ceil(2 * Math.PI * radiusM / ELEMENT_M));
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      corners.add(new Point(radiusM * StrictMath.cos(angle), radiusM * StrictMath.sin(angle)));
    }
    return of(corners);
  }

  private static void cut(Face face, boolean clockwise, List<double[]> elements, double share) {
    double dx = face.to.xM() - face.from.xM();
    double dz = face.to.zM() - face.from.zM();
    double length = face.lengthM();
    int count = Math.max(1, (int) Math.ceil(length / ELEMENT_M));
    double out = clockwise ? -1 : 1;
    for (int k = 0; k < count; k++) {
      double at = (k + 0.5) / count;
      elements.add(
          new double[] {
            face.from.xM() + at * dx,
            face.from.zM() + at * dz,
            out * dz / length,
            -out * dx / length,
            share * length / count
          });
    }
  }

  /** The radius of the circle round its own origin that holds it, in metres. */
  public double radiusM() {
    return radiusM;
  }

  /** True when a point is on the outer side of a face. */
  boolean sees(Face face, double x, double z) {
    double out = clockwise ? -1 : 1;
    double dx = face.to.xM() - face.from.xM();
    double dz = face.to.zM() - face.from.zM();
    return out * (dz * (x - face.from.xM()) - dx * (z - face.from.zM())) > 0;
  }

  /** True when no face stands between a point and an element. */
  boolean isFree(int element, double x, double z) {
    double aside = 1e-7;
    double ex = xM[element] + aside * normalX[element];
    double ez = zM[element] + aside * normalZ[element];
    for (Face face : faces) {
      if (face.parts(x, z, ex, ez)) {
        return false;
      }
    }
    return true;
  }

  int size() {
    return xM.length;
  }
}
