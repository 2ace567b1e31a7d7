package simbad.scene3d;

import javax.media.j3d.Appearance;
import javax.media.j3d.ColoringAttributes;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.IndexedTriangleArray;
import javax.media.j3d.Material;
import javax.media.j3d.Shape3D;
import javax.vecmath.Color3f;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Finish;
import simbad.kernel.drawing.Mesh;
import simbad.kernel.drawing.Rgb;

/** Coloured triangles as Java 3D shapes. */
final class Facet3D {
  private static final Color3f NONE = new Color3f();

  private Facet3D() {}

  /** Makes a shape of some triangles with one surface. */
  static Shape3D of(Facets facets) {
    return new Shape3D(geometry(facets.mesh()), appearance(facets.finish()));
  }

  static Color3f color(Rgb colour) {
    return new Color3f(colour.red(), colour.green(), colour.blue());
  }

  private static IndexedTriangleArray geometry(Mesh mesh) {
    IndexedTriangleArray array =
        new IndexedTriangleArray(
            mesh.vertices(),
            GeometryArray.COORDINATES | GeometryArray.NORMALS | GeometryArray.USE_COORD_INDEX_ONLY,
            3 * mesh.triangles());
    for (int i = 0; i < mesh.vertices(); i++) {
      array.setCoordinate(i, new double[] {mesh.xM(i), mesh.yM(i), mesh.zM(i)});
      array.setNormal(i, normal(mesh, i));
    }
    for (int i = 0; i < 3 * mesh.triangles(); i++) {
      array.setCoordinateIndex(i, mesh.vertex(i / 3, i % 3));
    }
    return array;
  }

  private static float[] normal(Mesh mesh, int vertex) {
    return new float[] {
      (float) mesh.normalX(vertex), (float) mesh.normalY(vertex), (float) mesh.normalZ(vertex)
    };
  }

  private static Appearance appearance(Finish finish) {
    Color3f color = color(finish.colour());
    Appearance appearance = new Appearance();
    if (!finish.lit()) {
      appearance.setColoringAttributes(
          new ColoringAttributes(color, ColoringAttributes.SHADE_FLAT));
      return appearance;
    }
    Material material = new Material(color(finish.ambient()), NONE, color, NONE, 1);
    material.setLightingEnable(true);
    appearance.setMaterial(material);
    return appearance;
  }
}
