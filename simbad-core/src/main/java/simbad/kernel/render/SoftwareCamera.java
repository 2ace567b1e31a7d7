package simbad.kernel.render;

import java.util.ArrayList;
import java.util.List;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Mesh;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.Placement;

/**
 * Takes pictures without a display. Of surfaces at the same depth the one that was on the stage
 * first is seen. After the first pictures of a stage it allocates nothing.
 */
public final class SoftwareCamera implements PictureSource {
  private final Stage stage;
  private final Frustum frustum = new Frustum();
  private final Clipper clipper = new Clipper(frustum);
  private final Raster raster = new Raster();
  private final Shader shader;
  private final Vertices vertices = new Vertices();
  private final Placement eyeFromWorld = new Placement();
  private final Placement eyeFromObject = new Placement();

  /** Where the object at hand is, after those that it is part of. */
  private final List<Placement> worldFromObjects = new ArrayList<>();

  /** Creates a camera for a stage, which is followed, not copied. */
  public SoftwareCamera(Stage stage) {
    this.stage = stage;
    shader = new Shader(stage.lighting());
    worldFromObjects.add(new Placement());
  }

  @Override
  public void take(Placement worldFromEye, Picture picture) {
    eyeFromWorld.invert(worldFromEye);
    frustum.fit(picture);
    raster.begin(picture, frustum.focalPx(picture), stage.background());
    for (int i = 0; i < stage.visuals().size(); i++) {
      draw(stage.visuals().get(i), 0);
    }
  }

  private void draw(Visual visual, int level) {
    if (!visual.isPresent()) {
      return;
    }
    if (worldFromObjects.size() == level + 1) {
      worldFromObjects.add(new Placement());
    }
    Placement worldFromObject = worldFromObjects.get(level + 1);
    worldFromObject.compose(worldFromObjects.get(level), visual.frameFromVisual());
    drawFacets(visual.facets(), worldFromObject);
    for (int i = 0; i < visual.parts().size(); i++) {
      draw(visual.parts().get(i), level + 1);
    }
  }

  private void drawFacets(List<Facets> facets, Placement worldFromObject) {
    eyeFromObject.compose(eyeFromWorld, worldFromObject);
    boolean placed = false;
    for (int i = 0; i < facets.size(); i++) {
      if (mayShow(facets.get(i).mesh())) {
        if (!placed) {
          shader.place(worldFromObject);
          placed = true;
        }
        shader.shade(facets.get(i), eyeFromObject, vertices);
        drawTriangles(facets.get(i).mesh());
      }
    }
  }

  private boolean mayShow(Mesh mesh) {
    return frustum.mayShow(
        eyeFromObject.xM(), eyeFromObject.zM(), eyeFromObject.yM(), mesh.radiusM());
  }

  private void drawTriangles(Mesh mesh) {
    for (int i = 0; i < mesh.triangles(); i++) {
      clipper.clip(vertices, mesh.vertex(i, 0), mesh.vertex(i, 1), mesh.vertex(i, 2));
      for (int corner = 2; corner < clipper.corners(); corner++) {
        raster.fill(clipper.polygon(), 0, corner - 1, corner);
      }
    }
  }
}
