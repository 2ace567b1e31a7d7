package simbad.kernel.drawing;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Collects vertices and triangles. */
final class MeshBuilder {
  private final DoubleStream.Builder positions = DoubleStream.builder();
  private final DoubleStream.Builder normals = DoubleStream.builder();
  private final IntStream.Builder corners = IntStream.builder();
  private double normalX;
  private double normalY;
  private double normalZ;
  private int vertices;

  /** Sets the normal, of any length above 0, that the next vertices get. */
  MeshBuilder facing(double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    normalX = x / length;
    normalY = y / length;
    normalZ = z / length;
    return this;
  }

  /** Adds a vertex and returns its number. */
  int vertex(double xM, double yM, double zM) {
    positions.add(xM).add(yM).add(zM);
    normals.add(normalX).add(normalY).add(normalZ);
    return vertices++;
  }

  /** Adds a triangle, counter-clockwise as seen from outside. */
  void triangle(int a, int b, int c) {
    corners.add(a).add(b).add(c);
  }

  /** Adds a rectangle or another convex quadrangle, counter-clockwise as seen from outside. */
  void quadrangle(int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  Mesh build() {
    return new Mesh(
        positions.build().toArray(), normals.build().toArray(), corners.build().toArray());
  }
}
