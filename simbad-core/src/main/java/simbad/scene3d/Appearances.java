package simbad.scene3d;

import javax.media.j3d.Appearance;
import javax.media.j3d.ColoringAttributes;
import javax.media.j3d.LineAttributes;
import javax.media.j3d.PointAttributes;
import javax.media.j3d.PolygonAttributes;
import javax.media.j3d.RenderingAttributes;
import javax.media.j3d.TransparencyAttributes;
import javax.vecmath.Color3f;

/** How things look that no light falls on: rays, cones, lines on the floor, lit lamps. */
final class Appearances {
  private Appearances() {}

  /** Returns an opaque appearance of one colour, as bright as the colour says. */
  static Appearance unlit(Color3f color) {
    Appearance appearance = new Appearance();
    appearance.setColoringAttributes(new ColoringAttributes(color, ColoringAttributes.SHADE_FLAT));
    appearance.setPolygonAttributes(bothSides());
    return appearance;
  }

  /**
   * Returns an appearance through which one sees; it hides nothing.
   *
   * @param color its colour
   * @param opacity in (0, 1)
   */
  static Appearance translucent(Color3f color, float opacity) {
    Appearance appearance = unlit(color);
    appearance.setTransparencyAttributes(
        new TransparencyAttributes(TransparencyAttributes.BLENDED, 1 - opacity));
    RenderingAttributes hidesNothing = new RenderingAttributes();
    hidesNothing.setDepthBufferWriteEnable(false);
    appearance.setRenderingAttributes(hidesNothing);
    return appearance;
  }

  /**
   * Returns a translucent appearance for lines and points.
   *
   * @param color its colour
   * @param opacity in (0, 1)
   * @param widthPx width of lines in pixels; points are three times as wide
   */
  static Appearance stroke(Color3f color, float opacity, float widthPx) {
    Appearance appearance = translucent(color, opacity);
    appearance.setLineAttributes(new LineAttributes(widthPx, LineAttributes.PATTERN_SOLID, true));
    appearance.setPointAttributes(new PointAttributes(3 * widthPx, true));
    return appearance;
  }

  private static PolygonAttributes bothSides() {
    PolygonAttributes attributes = new PolygonAttributes();
    attributes.setCullFace(PolygonAttributes.CULL_NONE);
    return attributes;
  }
}
