package simbad.kernel.drawing;

/**
 * Triangles between vertices, each vertex with its outward normal. Immutable. Corners that need
 * several normals, such as those of a box, are several vertices at one place.
 */
public final class Mesh {
  private final double[] positions;
  private final double[] normals;
  private final int[] corners;
  private final double radiusM;

  /** Takes over the arrays: x, y, z per vertex, and three vertices per triangle. */
  Mesh(double[] positions, double[] normals, int[] corners) {
    this.positions = positions;
    this.normals = normals;
    this.corners = corners;
    radiusM = radius(positions);
  }

  private static double radius(double[] positions) {
    double squared = 0;
    for (int i = 0; i < positions.length; i += 3) {
      double x = positions[i];
      double y = positions[i + 1];
      double z = positions[i + 2];
      squared = Math.max(squared, x * x + y * y + z * z);
    }
    return Math.sqrt(squared);
  }

  /** Returns the number of vertices. */
  public int vertices() {
    return positions.length / 3;
  }

  /** Returns the x coordinate of a vertex in metres. */
  public double xM(int vertex) {
    return positions[3 * vertex];
  }

  /** Returns the y coordinate of a vertex in metres. */
  public double yM(int vertex) {
    return positions[3 * vertex + 1];
  }

  /** Returns the z coordinate of a vertex in metres. */
  public double zM(int vertex) {
    return positions[3 * vertex + 2];
  }

  /** Returns the x component of a vertex' unit normal. */
  public double normalX(int vertex) {
    return normals[3 * vertex];
  }

  /** Returns the y component of a vertex' unit normal. */
  public double normalY(int vertex) {
    return normals[3 * vertex + 1];
  }

  /** Returns the z component of a vertex' unit normal. */
  public double normalZ(int vertex) {
    return normals[3 * vertex + 2];
  }

  /** Returns the number of triangles. */
  public int triangles() {
    return corners.length / 3;
  }

  /**
   * Returns the vertex at a triangle's corner; the corners run counter-clockwise as seen from
   * outside.
   *
   * @param corner 0, 1 or 2
   */
  public int vertex(int triangle, int corner) {
    return corners[3 * triangle + corner];
  }

  /** Returns the radius in metres of a ball about the origin that holds all vertices. */
  public double radiusM() {
    return radiusM;
  }

  /** Returns these triangles somewhere else. */
  public Mesh movedBy(double dxM, double dyM, double dzM) {
    double[] moved = positions.clone();
    for (int i = 0; i < moved.length; i += 3) {
      moved[i] += dxM;
      moved[i + 1] += dyM;
      moved[i + 2] += dzM;
    }
    return new Mesh(moved, normals, corners);
  }
}
