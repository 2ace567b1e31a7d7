package simbad.kernel.drawing;

import simbad.kernel.geometry.Shape;

/**
 * Triangles with one surface, in the frame of the object that they belong to.
 *
 * @param mesh the triangles
 * @param finish their surface
 */
public record Facets(Mesh mesh, Finish finish) {
  /** Returns a shape in the middle of its object, with a surface that light falls on. */
  public static Facets lit(Shape shape, Rgb colour) {
    return new Facets(Tessellation.of(shape), Finish.lit(colour));
  }

  /** Returns a shape in the middle of its object, with a surface that always shows its colour. */
  public static Facets plain(Shape shape, Rgb colour) {
    return new Facets(Tessellation.of(shape), Finish.plain(colour));
  }

  /** Returns these facets somewhere else in the object's frame. */
  public Facets movedBy(double dxM, double dyM, double dzM) {
    return new Facets(mesh.movedBy(dxM, dyM, dzM), finish);
  }
}
