package simbad.scene3d;

import javax.media.j3d.Appearance;
import javax.media.j3d.ColoringAttributes;
import javax.media.j3d.RenderingAttributes;
import javax.vecmath.Color3f;

/** A colour of lines that can be changed while they are shown. */
final class Ink {
  private final ColoringAttributes colouring;
  private final Appearance appearance;

  /**
   * Creates a colour.
   *
   * @param color at first
   * @param opacity in (0, 1)
   * @param widthPx of the lines
   */
  Ink(Color3f color, float opacity, float widthPx) {
    appearance = Appearances.stroke(color, opacity, widthPx);
    colouring = new ColoringAttributes(color, ColoringAttributes.SHADE_FLAT);
    colouring.setCapability(ColoringAttributes.ALLOW_COLOR_WRITE);
    appearance.setColoringAttributes(colouring);
  }

  /** Hides what lies below it, in whatever order the two are drawn. */
  Ink covering() {
    appearance.setRenderingAttributes(new RenderingAttributes());
    return this;
  }

  Appearance appearance() {
    return appearance;
  }

  void set(Color3f color) {
    colouring.setColor(color);
  }
}
