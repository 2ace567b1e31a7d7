package simbad.kernel.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.CylinderShape;
import simbad.kernel.geometry.PrismShape;

/** Meshes are closed, face outwards and hold the shape's volume. */
class TessellationTest {
  private static final double EPS = 1e-9;

  @Test
  void box_hasItsVolumeAndTwelveTriangles() {
    Mesh mesh = Tessellation.of(BoxShape.ofSides(2, 3, 4));
    assertEquals(12, mesh.triangles());
    assertEquals(24, mesh.vertices());
    checkVolume(24, mesh);
    checkNormals(mesh, 1 - EPS);
    assertEquals(Math.sqrt(1 + 1.5 * 1.5 + 4), mesh.radiusM(), EPS);
  }

  @Test
  void cylinder_hasTheVolumeOfItsPolygon() {
    Mesh mesh = Tessellation.of(new CylinderShape(0.3, 0.5));
    checkVolume(polygonArea(0.3) * 0.5, mesh);
    checkNormals(mesh, Math.cos(Math.PI / Tessellation.SIDES) - EPS);
  }

  private static double polygonArea(double radiusM) {
    return Tessellation.SIDES
        / 2.0
        * radiusM
        * radiusM
        * Math.sin(2 * Math.PI / Tessellation.SIDES);
  }

  /** The polyhedron inside a ball is smaller than the ball, by less than 3 % with 24 sides. */
  @Test
  void ball_hasNearlyItsVolume() {
    Mesh mesh = Tessellation.of(new BallShape(2));
    double share = volume(mesh) / (4 * Math.PI * 8 / 3);
    assertTrue(share > 0.97 && share < 1, "share of the volume " + share);
    checkNormals(mesh, 0.98);
  }

  /** An angle seen from above, as some obstacles are: not convex, and given clockwise. */
  @Test
  void prism_overAnAngle_hasItsVolume() {
    double[] x = {0, 3, 3, 1, 1, 0};
    double[] z = {0, 0, 1, 1, 3, 3};
    checkVolume(5 * 2, Tessellation.of(new PrismShape(x, z, 1, 3)));
    checkNormals(Tessellation.of(new PrismShape(x, z, 1, 3)), 1 - EPS);
  }

  @Test
  void prism_withACornerTwice_andOneOnAnEdge_hasItsVolume() {
    double[] x = {0, 1, 2, 2, 2, 0};
    double[] z = {0, 0, 0, 0, -2, -2};
    checkVolume(4, Tessellation.of(new PrismShape(x, z, 0, 1)));
  }

  /** Corners in order of their angle about the middle make a simple polygon. */
  @Property(tries = 200, seed = "20140914")
  void prism_overAnyStar_hasItsVolume(
      @ForAll @IntRange(min = 3, max = 30) int corners,
      @ForAll @IntRange(min = 0, max = 1) int sense,
      @ForAll long seed) {
    double[] radii = new Random(seed).doubles(corners, 0.2, 3).toArray();
    double[] x = new double[radii.length];
    double[] z = new double[radii.length];
    for (int i = 0; i < radii.length; i++) {
      double angle = 2 * Math.PI * i / radii.length * (1 - 2 * sense);
      x[i] = radii[i] * Math.cos(angle);
      z[i] = radii[i] * Math.sin(angle);
    }
    double area = 0;
    for (int i = 0; i < radii.length; i++) {
      double next = radii[(i + 1) % radii.length];
      area += radii[i] * next * Math.sin(2 * Math.PI / radii.length) / 2;
    }
    Mesh mesh = Tessellation.of(new PrismShape(x, z, -1, 1));
    checkVolume(2 * area, mesh);
    checkNormals(mesh, 1 - EPS);
  }

  @Test
  void movedBy_movesVerticesAndLeavesNormals() {
    Mesh mesh = Tessellation.of(BoxShape.ofSides(2, 2, 2));
    Mesh moved = mesh.movedBy(10, 20, 30);
    for (int i = 0; i < mesh.vertices(); i++) {
      assertEquals(mesh.xM(i) + 10, moved.xM(i));
      assertEquals(mesh.yM(i) + 20, moved.yM(i));
      assertEquals(mesh.zM(i) + 30, moved.zM(i));
      assertEquals(mesh.normalY(i), moved.normalY(i));
    }
    assertEquals(Math.sqrt(11 * 11 + 21 * 21 + 31 * 31), moved.radiusM(), EPS);
  }

  private static void checkVolume(double expected, Mesh mesh) {
    assertEquals(expected, volume(mesh), 1e-9 * Math.max(1, expected));
  }

  /** The divergence theorem: holes and triangles that face inwards change the sum. */
  private static double volume(Mesh mesh) {
    double sum = 0;
    for (int i = 0; i < mesh.triangles(); i++) {
      double[] n = cross(mesh, i);
      int a = mesh.vertex(i, 0);
      sum += (n[0] * mesh.xM(a) + n[1] * mesh.yM(a) + n[2] * mesh.zM(a)) / 6;
    }
    return sum;
  }

  /** Each vertex' normal is of length 1 and within an angle of the triangle's own one. */
  private static void checkNormals(Mesh mesh, double leastCosine) {
    for (int i = 0; i < mesh.triangles(); i++) {
      double[] n = cross(mesh, i);
      double area = Math.hypot(n[0], Math.hypot(n[1], n[2]));
      for (int corner = 0; corner < 3 && area > EPS; corner++) {
        int v = mesh.vertex(i, corner);
        double dot = n[0] * mesh.normalX(v) + n[1] * mesh.normalY(v) + n[2] * mesh.normalZ(v);
        assertTrue(dot / area >= leastCosine, "cosine " + dot / area + " of triangle " + i);
      }
    }
  }

  private static double[] cross(Mesh mesh, int triangle) {
    int a = mesh.vertex(triangle, 0);
    int b = mesh.vertex(triangle, 1);
    int c = mesh.vertex(triangle, 2);
    double ux = mesh.xM(b) - mesh.xM(a);
    double uy = mesh.yM(b) - mesh.yM(a);
    double uz = mesh.zM(b) - mesh.zM(a);
    double vx = mesh.xM(c) - mesh.xM(a);
    double vy = mesh.yM(c) - mesh.yM(a);
    double vz = mesh.zM(c) - mesh.zM(a);
    return new double[] {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  }
}
