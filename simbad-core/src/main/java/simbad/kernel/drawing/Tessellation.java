package simbad.kernel.drawing;

import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.CylinderShape;
import simbad.kernel.geometry.PrismShape;
import simbad.kernel.geometry.Shape;

/**
 * Shapes as triangles. Boxes and prisms are exact, with flat faces. Round shapes have their
 * vertices on the true surface, {@value #SIDES} round their axis, and the true normals there.
 */
public final class Tessellation {
  /** Number of vertices round the axis of a cylinder or a ball. */
  public static final int SIDES = 24;

  private static final int RINGS = SIDES / 2;

  private Tessellation() {}

  /** Returns a shape's surface in the shape's own frame. */
  public static Mesh of(Shape shape) {
    if (shape instanceof BoxShape box) {
      return box(box);
    }
    if (shape instanceof CylinderShape cylinder) {
      return cylinder(cylinder);
    }
    if (shape instanceof PrismShape prism) {
      return prism(prism);
    }
    return ball((BallShape) shape);
  }

  private static Mesh box(BoxShape box) {
    MeshBuilder mesh = new MeshBuilder();
    for (int side = -1; side <= 1; side += 2) {
      for (int axis = 0; axis < 3; axis++) {
        addFace(mesh, axis, side, box);
      }
    }
    return mesh.build();
  }

  /** Adds the face across an axis; seen from outside, the next axis and the one after turn ccw. */
  private static void addFace(MeshBuilder mesh, int axis, int side, BoxShape box) {
    double[] half = {box.halfXM(), box.halfYM(), box.halfZM()};
    double[] at = new double[3];
    at[axis] = side;
    mesh.facing(at[0], at[1], at[2]);
    at[axis] = side * half[axis];
    int across = (axis + 1) % 3;
    int up = (axis + 2) % 3;
    int[] vertices = new int[4];
    for (int corner = 0; corner < 4; corner++) {
      at[across] = half[across] * (corner == 1 || corner == 2 ? side : -side);
      at[up] = half[up] * (corner >= 2 ? 1 : -1);
      vertices[corner] = mesh.vertex(at[0], at[1], at[2]);
    }
    mesh.quadrangle(vertices[0], vertices[1], vertices[2], vertices[3]);
  }

  private static Mesh cylinder(CylinderShape cylinder) {
    MeshBuilder mesh = new MeshBuilder();
    double top = cylinder.heightM() / 2;
    double[] x = new double[SIDES];
    double[] z = new double[SIDES];
    for (int side = 0; side < SIDES; side++) {
      x[side] = cylinder.radiusM() * cos(side);
      z[side] = -cylinder.radiusM() * sin(side);
    }
    for (int side = 0; side <= SIDES; side++) {
      mesh.facing(cos(side), 0, -sin(side));
      mesh.vertex(x[side % SIDES], -top, z[side % SIDES]);
      mesh.vertex(x[side % SIDES], top, z[side % SIDES]);
    }
    for (int side = 0; side < SIDES; side++) {
      mesh.quadrangle(2 * side, 2 * side + 2, 2 * side + 3, 2 * side + 1);
    }
    addLids(mesh, x, z, -top, top);
    return mesh.build();
  }

  /** Adds the upper and the lower face of a polygon that runs counter-clockwise from above. */
  private static void addLids(
      MeshBuilder mesh, double[] x, double[] z, double bottomM, double topM) {
    int[] triangles = PolygonTriangles.of(x, z);
    int lower = addLevel(mesh.facing(0, -1, 0), x, z, bottomM);
    int upper = addLevel(mesh.facing(0, 1, 0), x, z, topM);
    for (int i = 0; i < triangles.length; i += 3) {
      int a = triangles[i];
      int b = triangles[i + 1];
      int c = triangles[i + 2];
      mesh.triangle(upper + a, upper + b, upper + c);
      mesh.triangle(lower + c, lower + b, lower + a);
    }
  }

  private static int addLevel(MeshBuilder mesh, double[] x, double[] z, double levelM) {
    int first = mesh.vertex(x[0], levelM, z[0]);
    for (int i = 1; i < x.length; i++) {
      mesh.vertex(x[i], levelM, z[i]);
    }
    return first;
  }

  private static Mesh prism(PrismShape prism) {
    MeshBuilder mesh = new MeshBuilder();
    int corners = prism.corners();
    double[] x = new double[corners];
    double[] z = new double[corners];
    boolean reverse = areaFromAbove(prism) < 0;
    for (int i = 0; i < corners; i++) {
      int from = reverse ? corners - 1 - i : i;
      x[i] = prism.cornerX(from);
      z[i] = prism.cornerZ(from);
    }
    for (int i = 0; i < corners; i++) {
      addWall(mesh, x, z, i, prism);
    }
    addLids(mesh, x, z, prism.bottomM(), prism.topM());
    return mesh.build();
  }

  private static void addWall(
      MeshBuilder mesh, double[] x, double[] z, int from, PrismShape prism) {
    int to = (from + 1) % x.length;
    if (x[from] == x[to] && z[from] == z[to]) {
      return;
    }
    mesh.facing(z[from] - z[to], 0, x[to] - x[from]);
    int a = mesh.vertex(x[from], prism.bottomM(), z[from]);
    int b = mesh.vertex(x[to], prism.bottomM(), z[to]);
    int c = mesh.vertex(x[to], prism.topM(), z[to]);
    int d = mesh.vertex(x[from], prism.topM(), z[from]);
    mesh.quadrangle(a, b, c, d);
  }

  /** Twice the polygon's area, positive if it runs counter-clockwise as seen from above. */
  private static double areaFromAbove(PrismShape prism) {
    double sum = 0;
    for (int i = 0; i < prism.corners(); i++) {
      int next = (i + 1) % prism.corners();
      sum += prism.cornerZ(i) * prism.cornerX(next) - prism.cornerX(i) * prism.cornerZ(next);
    }
    return sum;
  }

  private static Mesh ball(BallShape ball) {
    MeshBuilder mesh = new MeshBuilder();
    double r = ball.radiusM();
    for (int ring = 0; ring <= RINGS; ring++) {
      double y = -Math.cos(Math.PI * ring / RINGS);
      double out = Math.sin(Math.PI * ring / RINGS);
      for (int side = 0; side <= SIDES; side++) {
        double x = out * cos(side);
        double z = -out * sin(side);
        mesh.facing(x, y, z).vertex(r * x, r * y, r * z);
      }
    }
    int row = SIDES + 1;
    for (int at = 0; at < RINGS * row; at++) {
      if (at % row < SIDES) {
        mesh.quadrangle(at, at + 1, at + 1 + row, at + row);
      }
    }
    return mesh.build();
  }

  private static double cos(int side) {
    return Math.cos(2 * Math.PI * (side % SIDES) / SIDES);
  }

  private static double sin(int side) {
    return Math.sin(2 * Math.PI * (side % SIDES) / SIDES);
  }
}
