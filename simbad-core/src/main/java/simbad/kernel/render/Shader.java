package simbad.kernel.render;

import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Finish;
import simbad.kernel.drawing.Lighting;
import simbad.kernel.drawing.Mesh;
import simbad.kernel.drawing.PointLight;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.geometry.Placement;

/** Puts an object's vertices into the eye's frame and gives them the colour that is seen. */
final class Shader {
  private final Lighting lighting;
  private final Placement objectFromWorld = new Placement();

  /** The lamps in the object's frame, x, y and z each. */
  private final double[] lampsM;

  Shader(Lighting lighting) {
    this.lighting = lighting;
    lampsM = new double[3 * lighting.lamps().size()];
  }

  /** Takes note of where the object is whose facets come next. */
  void place(Placement worldFromObject) {
    objectFromWorld.invert(worldFromObject);
    for (int i = 0; i < lighting.lamps().size(); i++) {
      PointLight lamp = lighting.lamps().get(i);
      lampsM[3 * i] = objectFromWorld.outerX(lamp.xM(), lamp.yM(), lamp.zM());
      lampsM[3 * i + 1] = objectFromWorld.outerY(lamp.xM(), lamp.yM(), lamp.zM());
      lampsM[3 * i + 2] = objectFromWorld.outerZ(lamp.xM(), lamp.yM(), lamp.zM());
    }
  }

  void shade(Facets facets, Placement eyeFromObject, Vertices vertices) {
    Mesh mesh = facets.mesh();
    vertices.reserve(mesh.vertices());
    for (int i = 0; i < mesh.vertices(); i++) {
      double x = mesh.xM(i);
      double y = mesh.yM(i);
      double z = mesh.zM(i);
      vertices.setPlace(
          i,
          eyeFromObject.outerX(x, y, z),
          eyeFromObject.outerZ(x, y, z),
          eyeFromObject.outerY(x, y, z));
      if (facets.finish().lit()) {
        light(mesh, i, facets.finish(), vertices);
      } else {
        Rgb colour = facets.finish().colour();
        vertices.setColour(i, colour.red(), colour.green(), colour.blue());
      }
    }
  }

  /** See {@link Lighting} for the formula. */
  private void light(Mesh mesh, int vertex, Finish finish, Vertices vertices) {
    double red = 0;
    double green = 0;
    double blue = 0;
    for (int i = 0; i < lighting.lamps().size(); i++) {
      double strength = cosine(mesh, vertex, i) / Lighting.ATTENUATION;
      Rgb lamp = lighting.lamps().get(i).colour();
      red += lamp.red() * strength;
      green += lamp.green() * strength;
      blue += lamp.blue() * strength;
    }
    Rgb colour = finish.colour();
    Rgb reflected = finish.ambient();
    Rgb around = lighting.ambient();
    vertices.setColour(
        vertex,
        Math.min(1, reflected.red() * around.red() + colour.red() * red),
        Math.min(1, reflected.green() * around.green() + colour.green() * green),
        Math.min(1, reflected.blue() * around.blue() + colour.blue() * blue));
  }

  /** Cosine of the angle between a vertex' normal and its lamp, 0 if the lamp is behind. */
  private double cosine(Mesh mesh, int vertex, int lamp) {
    double x = lampsM[3 * lamp] - mesh.xM(vertex);
    double y = lampsM[3 * lamp + 1] - mesh.yM(vertex);
    double z = lampsM[3 * lamp + 2] - mesh.zM(vertex);
    double along = x * mesh.normalX(vertex) + y * mesh.normalY(vertex) + z * mesh.normalZ(vertex);
    return along > 0 ? along / Math.sqrt(x * x + y * y + z * z) : 0;
  }
}
