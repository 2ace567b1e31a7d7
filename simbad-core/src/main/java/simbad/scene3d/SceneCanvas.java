package simbad.scene3d;

import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.geom.AffineTransform;
import javax.media.j3d.Canvas3D;

/** A canvas that fills its place on screens that are scaled, too. */
final class SceneCanvas extends Canvas3D {
  private static final int LEAST_PX = 1;

  SceneCanvas(GraphicsConfiguration configuration) {
    super(configuration);
    // Keys belong to the window: a robot may listen to them.
    setFocusable(false);
  }

  /** Returns the size in device pixels, which Java 3D takes it for; layouts go by the bounds. */
  @Override
  public Dimension getSize() {
    AffineTransform scale = getGraphicsConfiguration().getDefaultTransform();
    return new Dimension(
        (int) Math.round(getWidth() * scale.getScaleX()),
        (int) Math.round(getHeight() * scale.getScaleY()));
  }

  /** A split or tiled window may make it as small as it likes. */
  @Override
  public Dimension getMinimumSize() {
    return new Dimension(LEAST_PX, LEAST_PX);
  }
}
