package simbad.scene3d;

import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.vecmath.Matrix3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.run.Pacer;
import simbad.sonar.check.Checks;

/**
 * A scene in a canvas. A thread of its own copies what has changed up to 60 times a second: faster
 * steps are left out, and a scene at rest is not drawn again. Safe for use by several threads.
 */
public final class DisplayScene {
  private static final double FRAME_S = 1 / 60.0;

  private final CanvasUniverse universe;
  private final StepHold hold;
  private final Viewpoint viewpoint = new Viewpoint();
  private final List<Animated> parts = new CopyOnWriteArrayList<>();
  private final List<NameTag> tags = new CopyOnWriteArrayList<>();
  private final Backdrop backdrop;
  private final Pacer pacer = new Pacer("world view");
  private final Transform3D eye = new Transform3D();
  private final Transform3D eyeShown = new Transform3D();
  private @Nullable Figure followed;
  private Lookout lookout = Lookout.TOP;
  private volatile Look look = Look.LIGHT;
  private Look lookShown = Look.LIGHT;

  /**
   * Creates a scene without figures and starts drawing it.
   *
   * @param stage gives the light; its visuals are not added
   * @param sideM side of the world's floor, metres, above 0
   * @param backdrop colours of the floor and the background
   * @param hold keeps steps away while the scene copies
   * @throws DisplayException if Java 3D cannot draw here
   */
  public DisplayScene(Stage stage, double sideM, Backdrop backdrop, StepHold hold) {
    universe = CanvasUniverse.open(Checks.positive("sideM", sideM));
    this.hold = hold;
    this.backdrop = backdrop;
    universe.add(Illumination.lights(stage));
    Ground ground = new Ground(sideM, backdrop);
    parts.add(ground);
    universe.add(ground.node());
    start();
  }

  /** Returns the canvas, which belongs into one window. */
  public Canvas3D canvas() {
    return universe.canvas();
  }

  /** Returns the group that carries the eye. */
  public TransformGroup eye() {
    return universe.eye();
  }

  /** Returns where the eye is; changes are drawn with the next frame. */
  public Viewpoint viewpoint() {
    return viewpoint;
  }

  /** Shows a figure from now on. */
  public void add(Figure figure) {
    add(figure, figure.node());
  }

  /** Shows where something has been, from now on. */
  public void add(Trail trail) {
    add(trail, trail.node());
  }

  /** Shows a name from now on. */
  public void add(NameTag tag) {
    tags.add(tag);
    add(tag, tag.node());
  }

  private void add(Animated part, BranchGroup node) {
    part.adopt(backdrop.onFloor(look));
    parts.add(part);
    universe.add(node);
  }

  /** Says how the scene is shown from the next frame on. */
  public void show(Look wanted) {
    look = wanted;
  }

  /** Returns what a legend of this scene explains. */
  public Set<Sign> signs() {
    Set<Sign> all = EnumSet.noneOf(Sign.class);
    parts.forEach(part -> all.addAll(part.signs()));
    return all;
  }

  /**
   * Takes a picture of what the canvas shows. It waits for a frame to be drawn.
   *
   * @throws DisplayException if there is none, as while the canvas is hidden
   */
  public BufferedImage photograph() {
    return universe.photograph();
  }

  /**
   * Puts the eye at a lookout.
   *
   * @param lookout where to look from
   * @param sizes what its distances go by
   * @param figure whom to follow; null for lookouts that follow nobody
   */
  public synchronized void look(Lookout lookout, Lookout.Sizes sizes, @Nullable Figure figure) {
    followed = figure;
    this.lookout = lookout;
    viewpoint.setAnchor(new Transform3D());
    lookout.place(viewpoint, sizes);
    universe.look(lookout);
    followFigure();
  }

  /** Copies what has changed and draws it; a copy that a step holds up for long is left out. */
  public void refresh() {
    adoptLook();
    if (hold.take()) {
      try {
        parts.forEach(Animated::capture);
      } finally {
        hold.release();
      }
      parts.forEach(Animated::show);
      followFigure();
    }
    showEye();
  }

  private void adoptLook() {
    Look wanted = look;
    if (!wanted.equals(lookShown)) {
      lookShown = wanted;
      Look onFloor = backdrop.onFloor(wanted);
      parts.forEach(part -> part.adopt(part instanceof Ground ? wanted : onFloor));
    }
  }

  private synchronized void followFigure() {
    if (followed != null) {
      Transform3D anchor = new Transform3D();
      followed.get(anchor);
      anchor.setRotation(level(lookout.anchorTurnRad(anchor)));
      viewpoint.setAnchor(anchor);
    }
  }

  /** A turn about the vertical alone: the eye does not roll with a tilted body. */
  private static Matrix3d level(double turnRad) {
    Matrix3d turn = new Matrix3d();
    turn.rotY(turnRad);
    return turn;
  }

  private synchronized void showEye() {
    viewpoint.get(eye);
    if (!eye.equals(eyeShown)) {
      eyeShown.set(eye);
      universe.eye().setTransform(eye);
    }
    double pixelShare = universe.pixelShare();
    tags.forEach(tag -> tag.face(eye, pixelShare));
  }

  /** Draws from now on whenever something has changed. */
  public void start() {
    universe.start();
    pacer.start(FRAME_S, this::refresh);
  }

  /** Draws no more. */
  public void stop() {
    pacer.stop();
    universe.stop();
  }

  /** Draws once while stopped. */
  public void drawOnce() {
    refresh();
    universe.drawOnce();
  }

  /** Says who is told, on a thread of Java 3D's, why drawing has failed. */
  public void whenFailed(Consumer<String> listener) {
    universe.whenFailed(listener);
  }

  /** Stops and frees what Java 3D holds; the canvas is of no use any more. */
  public void dispose() {
    pacer.stop();
    universe.close();
    parts.clear();
    tags.clear();
    synchronized (this) {
      followed = null;
    }
  }
}
