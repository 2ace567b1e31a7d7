package simbad.scene3d;

import java.awt.GraphicsConfiguration;
import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.GraphicsConfigTemplate3D;
import javax.media.j3d.ImageComponent;
import javax.media.j3d.ImageComponent2D;
import javax.media.j3d.PhysicalBody;
import javax.media.j3d.PhysicalEnvironment;
import javax.media.j3d.Screen3D;
import javax.media.j3d.TransformGroup;
import javax.media.j3d.View;
import javax.media.j3d.ViewPlatform;
import simbad.kernel.render.Picture;
import simbad.kernel.render.PictureSource;

/** A canvas out of sight, for pictures of one size. */
final class Film {
  private static final double FAR_M = 1000;

  /** Any physical size does; Java 3D wants one. */
  private static final double METRES_PER_PIXEL = 0.0254 / 90;

  private final int width;
  private final int height;
  private final Canvas3D canvas;
  private final View view = new View();
  private final ImageComponent2D buffer;

  Film(int width, int height, TransformGroup eye) {
    this.width = width;
    this.height = height;
    canvas = new Canvas3D(configuration(), true);
    Screen3D screen = canvas.getScreen3D();
    screen.setSize(width, height);
    screen.setPhysicalScreenWidth(width * METRES_PER_PIXEL);
    screen.setPhysicalScreenHeight(height * METRES_PER_PIXEL);
    buffer =
        new ImageComponent2D(
            ImageComponent.FORMAT_RGB,
            new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB));
    buffer.setCapability(ImageComponent.ALLOW_IMAGE_READ);
    canvas.setOffScreenBuffer(buffer);
    view.setPhysicalBody(new PhysicalBody());
    view.setPhysicalEnvironment(new PhysicalEnvironment());
    view.setFieldOfView(PictureSource.FIELD_OF_VIEW_RAD);
    view.setFrontClipPolicy(View.VIRTUAL_EYE);
    view.setBackClipPolicy(View.VIRTUAL_EYE);
    view.setFrontClipDistance(PictureSource.NEAR_M);
    view.setBackClipDistance(FAR_M);
    view.addCanvas3D(canvas);
    ViewPlatform platform = new ViewPlatform();
    BranchGroup branch = new BranchGroup();
    branch.addChild(platform);
    eye.addChild(branch);
    view.attachViewPlatform(platform);
  }

  /** Asked once: each question opens a connection to the display that Java 3D never closes. */
  private static final class Asked {
    private static final Optional<GraphicsConfiguration> BEST =
        ConfigurationQuery.ask(new GraphicsConfigTemplate3D());
  }

  /**
   * Returns what canvases out of sight are made with.
   *
   * @throws DisplayException if the screen has nothing suitable
   */
  static GraphicsConfiguration configuration() {
    return Asked.BEST.orElseThrow(
        () -> Missing.openGl("the screen offers no suitable configuration"));
  }

  boolean fits(Picture picture) {
    return picture.width() == width && picture.height() == height;
  }

  /**
   * Takes a picture of the scene as it is. Under load, Java 3D drew 2 of 36,000 pictures while what
   * was moved before was still on its way to the drawing. One picture ends before the next begins,
   * so the second shows the scene as it was left: 0 of 72,000.
   */
  void expose(Picture picture) {
    for (int i = 0; i < 2; i++) {
      canvas.renderOffScreenBuffer();
      canvas.waitForOffScreenRendering();
    }
    buffer.getImage().getRGB(0, 0, width, height, picture.argb(), 0, width);
  }

  void close() {
    canvas.setOffScreenBuffer(null);
    view.removeAllCanvas3Ds();
    view.attachViewPlatform(null);
  }
}
