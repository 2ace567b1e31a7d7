package simbad.scene3d;

import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.ImageComponent;
import javax.media.j3d.ImageComponent2D;
import javax.media.j3d.Raster;
import org.jspecify.annotations.Nullable;

/** A canvas that fills its place on screens that are scaled, too. */
final class SceneCanvas extends Canvas3D {
  private static final int LEAST_PX = 1;

  private final AtomicReference<@Nullable CompletableFuture<BufferedImage>> wanted =
      new AtomicReference<>();

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

  /** Takes a picture of the next frame that is drawn; whoever asked before gets none. */
  CompletableFuture<BufferedImage> photographNextFrame() {
    CompletableFuture<BufferedImage> picture = new CompletableFuture<>();
    wanted.set(picture);
    return picture;
  }

  /**
   * Called by Java 3D's thread with the frame drawn, before it is seen: nothing covers it there.
   */
  @Override
  public void postRender() {
    CompletableFuture<BufferedImage> picture = wanted.getAndSet(null);
    if (picture != null) {
      picture.completeAsync(this::readFrame, Runnable::run);
    }
  }

  private BufferedImage readFrame() {
    Dimension size = getSize();
    BufferedImage image = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
    Raster raster = new Raster();
    raster.setCapability(Raster.ALLOW_IMAGE_READ);
    raster.setSize(size);
    raster.setImage(new ImageComponent2D(ImageComponent.FORMAT_RGB, image));
    getGraphicsContext3D().readRaster(raster);
    return raster.getImage().getImage();
  }

  /** A split or tiled window may make it as small as it likes. */
  @Override
  public Dimension getMinimumSize() {
    return new Dimension(LEAST_PX, LEAST_PX);
  }
}
