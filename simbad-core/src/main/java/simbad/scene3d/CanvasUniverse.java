package simbad.scene3d;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.GraphicsConfigTemplate3D;
import javax.media.j3d.Locale;
import javax.media.j3d.PhysicalBody;
import javax.media.j3d.PhysicalEnvironment;
import javax.media.j3d.RenderingError;
import javax.media.j3d.RenderingErrorListener;
import javax.media.j3d.TransformGroup;
import javax.media.j3d.View;
import javax.media.j3d.ViewPlatform;
import javax.media.j3d.VirtualUniverse;
import org.jspecify.annotations.Nullable;

/** A universe of Java 3D with one canvas and one eye. */
final class CanvasUniverse {
  private static final double NEAR_M = 0.02;

  /** How far one can see, in sides of the world. */
  private static final double FAR_SIDES = 20;

  private static final double LEAST_FAR_M = 100;

  private static final long PATIENCE_S = 10;

  private static @Nullable GraphicsConfiguration configuration;

  static {
    // Java 3D draws with desktop OpenGL alone; not to look for the others saves a quarter of a
    // second.
    System.setProperty("jogl.disable.opengles", "true");
  }

  private final VirtualUniverse universe = new VirtualUniverse();
  private final Locale locale = new Locale(universe);
  private final View view = new View();
  private final TransformGroup eye = new TransformGroup();
  private final SceneCanvas canvas;
  private final RenderingErrorListener errors = this::fail;
  private volatile Consumer<String> failure = message -> {};
  private volatile Lookout lookout = Lookout.TOP;

  private CanvasUniverse(GraphicsConfiguration configuration) {
    canvas = new SceneCanvas(configuration);
  }

  /**
   * Opens a stage.
   *
   * @param sideM side of the world, metres
   * @throws DisplayException if Java 3D cannot draw here
   */
  static CanvasUniverse open(double sideM) {
    if (GraphicsEnvironment.isHeadless()) {
      throw Missing.display();
    }
    try {
      synchronized (UniverseLock.LOCK) {
        DrawingErrors.await();
        CanvasUniverse stage = new CanvasUniverse(configuration());
        stage.build(sideM);
        return stage;
      }
    } catch (RuntimeException | LinkageError e) {
      throw DrawingErrors.findLast().map(Missing::openGl).orElseGet(() -> Missing.of(e));
    }
  }

  /** Asks Java 3D once: each question costs a connection to the display that stays open. */
  private static synchronized GraphicsConfiguration configuration() {
    if (configuration == null) {
      configuration = findConfiguration();
    }
    return configuration;
  }

  private static GraphicsConfiguration findConfiguration() {
    GraphicsConfigTemplate3D template = new GraphicsConfigTemplate3D();
    template.setSceneAntialiasing(GraphicsConfigTemplate3D.PREFERRED);
    return ConfigurationQuery.ask(template)
        .orElseThrow(() -> Missing.openGl("the screen offers no suitable configuration"));
  }

  private void build(double sideM) {
    view.setPhysicalBody(new PhysicalBody());
    view.setPhysicalEnvironment(new PhysicalEnvironment());
    view.setFrontClipPolicy(View.VIRTUAL_EYE);
    view.setBackClipPolicy(View.VIRTUAL_EYE);
    view.setFrontClipDistance(NEAR_M);
    view.setBackClipDistance(Math.max(LEAST_FAR_M, FAR_SIDES * sideM));
    view.setTransparencySortingPolicy(View.TRANSPARENCY_SORT_GEOMETRY);
    view.setSceneAntialiasingEnable(true);
    view.addCanvas3D(canvas);
    canvas.addComponentListener(new FieldBySize());
    ViewPlatform platform = new ViewPlatform();
    eye.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
    eye.setCapability(TransformGroup.ALLOW_TRANSFORM_READ);
    eye.addChild(platform);
    eye.addChild(Illumination.headlight());
    view.attachViewPlatform(platform);
    DrawingErrors.add(errors);
    BranchGroup branch = new BranchGroup();
    branch.setCapability(BranchGroup.ALLOW_DETACH);
    branch.addChild(eye);
    locale.addBranchGraph(branch);
  }

  /** A window of another shape shows more or less of the height. */
  private final class FieldBySize extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent event) {
      widen();
    }
  }

  /** Makes the field of view what the place of the eye needs. */
  void look(Lookout from) {
    lookout = from;
    widen();
  }

  private void widen() {
    int width = canvas.getWidth();
    int height = canvas.getHeight();
    if (width > 0 && height > 0) {
      view.setFieldOfView(lookout.fieldOfViewRad(width, height));
    }
  }

  private void fail(RenderingError error) {
    failure.accept(Missing.openGl(error.getErrorMessage()).getMessage());
  }

  Canvas3D canvas() {
    return canvas;
  }

  TransformGroup eye() {
    return eye;
  }

  /** Returns the width of a pixel of the picture at a distance of 1. */
  double pixelShare() {
    return 2 * Math.tan(view.getFieldOfView() / 2) / Math.max(1, canvas.getWidth());
  }

  /**
   * Takes a picture of what the canvas shows, with the next frame.
   *
   * @throws DisplayException if no frame is drawn, as while the canvas is hidden
   */
  BufferedImage photograph() {
    CompletableFuture<BufferedImage> picture = canvas.photographNextFrame();
    try {
      // A scene at rest is not drawn again by itself.
      view.repaint();
      drawOnce();
      return picture.get(PATIENCE_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw Missing.frame(e);
    } catch (ExecutionException | TimeoutException e) {
      throw Missing.frame(e);
    }
  }

  void add(BranchGroup branch) {
    branch.setCapability(BranchGroup.ALLOW_DETACH);
    locale.addBranchGraph(branch);
  }

  void whenFailed(Consumer<String> listener) {
    failure = listener;
  }

  void start() {
    view.startView();
  }

  void stop() {
    view.stopView();
  }

  void drawOnce() {
    if (!view.isViewRunning()) {
      view.renderOnce();
    }
  }

  void close() {
    synchronized (UniverseLock.LOCK) {
      DrawingErrors.remove(errors);
      view.stopView();
      canvas.stopRenderer();
      view.removeAllCanvas3Ds();
      detach();
      universe.removeAllLocales();
    }
  }

  /** Java 3D's own thread may have let go of the universe with the last canvas: then it is done. */
  private void detach() {
    try {
      view.attachViewPlatform(null);
    } catch (NullPointerException alreadyGone) {
      // It asks a view for its universe without looking whether it has one.
    }
  }
}
