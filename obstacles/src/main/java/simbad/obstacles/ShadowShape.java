package simbad.obstacles;

import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.util.Optional;
import javax.media.j3d.Appearance;
import javax.media.j3d.ColoringAttributes;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.PolygonAttributes;
import javax.media.j3d.RenderingAttributes;
import javax.media.j3d.Shape3D;
import javax.media.j3d.TransparencyAttributes;
import javax.media.j3d.TriangleArray;
import javax.vecmath.Color3f;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.DetectionShadow;

/**
 * A detection shadow for the world view: the very triangles of the plain shadow, seen through.
 *
 * <p>Java 3D makes shapes only where there is a display; elsewhere the constructors fail.
 */
public class ShadowShape extends Shape3D {
  private static final Color3f BURLYWOOD = new Color3f(new Color(222, 184, 135));
  private static final float TRANSPARENCY = 0.6f;
  private static final int COORDINATES = 3;

  /**
   * Creates the shape of a shadow, in the obstacle's own frame.
   *
   * @param shadow to draw
   * @param heightM of the prism that stands on the floor, metres, positive
   */
  public ShadowShape(DetectionShadow shadow, double heightM) {
    super(geometry(shadow, Checks.positive("heightM", heightM)), appearance());
  }

  /** Creates the shape of a type's shadow, as high as its body. */
  ShadowShape(ObstacleType type) {
    this(new DetectionShadow(type.thresholds().table()), SonarObstacle.BODY_HEIGHT_M);
  }

  /**
   * Makes the shape of a shadow, in the obstacle's own frame.
   *
   * @param shadow to draw
   * @param heightM of the prism, metres, positive
   * @return nothing where there is no display
   */
  public static Optional<Shape3D> find(DetectionShadow shadow, double heightM) {
    return GraphicsEnvironment.isHeadless()
        ? Optional.empty()
        : Optional.of(new ShadowShape(shadow, heightM));
  }

  /**
   * Returns the geometry of a shadow; needs no display.
   *
   * @param shadow to draw
   * @param heightM of the prism, metres, positive
   */
  public static TriangleArray geometry(DetectionShadow shadow, double heightM) {
    double[] coordinates = shadow.triangles(heightM);
    TriangleArray triangles =
        new TriangleArray(coordinates.length / COORDINATES, GeometryArray.COORDINATES);
    triangles.setCoordinates(0, coordinates);
    triangles.setCapability(GeometryArray.ALLOW_COORDINATE_READ);
    triangles.setCapability(GeometryArray.ALLOW_COUNT_READ);
    return triangles;
  }

  private static Appearance appearance() {
    Appearance appearance = new Appearance();
    appearance.setTransparencyAttributes(
        new TransparencyAttributes(TransparencyAttributes.BLENDED, TRANSPARENCY));
    appearance.setColoringAttributes(
        new ColoringAttributes(BURLYWOOD, ColoringAttributes.SHADE_FLAT));
    PolygonAttributes bothSides = new PolygonAttributes();
    bothSides.setCullFace(PolygonAttributes.CULL_NONE);
    // Its base lies in the floor, and has to win over it everywhere.
    bothSides.setPolygonOffset(-1);
    bothSides.setPolygonOffsetFactor(-1);
    RenderingAttributes hidesNothing = new RenderingAttributes();
    hidesNothing.setDepthBufferWriteEnable(false);
    appearance.setRenderingAttributes(hidesNothing);
    appearance.setPolygonAttributes(bothSides);
    return appearance;
  }
}
