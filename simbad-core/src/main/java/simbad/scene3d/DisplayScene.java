package simbad.scene3d;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.run.Pacer;

/**
 * A scene in a canvas. A thread of its own copies what has changed up to 60 times a second: faster
 * steps are left out, and a scene at rest is not drawn again. Safe for use by several threads.
 */
public final class DisplayScene {
  private static final double FRAME_S = 1 / 60.0;

  private final CanvasUniverse universe;
  private final StepHold hold;
  private final Viewpoint viewpoint = new Viewpoint();
  private final List<Figure> figures = new CopyOnWriteArrayList<>();
  private final Pacer pacer = new Pacer("world view");
  private final Transform3D eye = new Transform3D();
  private final Transform3D eyeShown = new Transform3D();
  private @Nullable Figure followed;
  private boolean turnsToo;

  /**
   * Creates a scene without figures and starts drawing it.
   *
   * @param stage gives the light and the background; its visuals are not added
   * @param sideM side of the world's floor, metres, above 0
   * @param hold keeps steps away while the scene copies
   * @throws DisplayException if Java 3D cannot draw here
   */
  public DisplayScene(Stage stage, double sideM, StepHold hold) {
    universe = CanvasUniverse.open(sideM);
    this.hold = hold;
    universe.add(Illumination.of(stage));
    universe.add(Grid.of(sideM));
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
    figures.add(figure);
    universe.add(figure.node());
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
    turnsToo = lookout.turns();
    viewpoint.setAnchor(new Transform3D());
    lookout.place(viewpoint, sizes);
    universe.look(lookout);
    followFigure();
  }

  /** Copies what has changed and draws it; a copy that a step holds up for long is left out. */
  public void refresh() {
    if (hold.take()) {
      try {
        figures.forEach(Figure::capture);
      } finally {
        hold.release();
      }
      figures.forEach(Figure::show);
      followFigure();
    }
    showEye();
  }

  private synchronized void followFigure() {
    if (followed != null) {
      Transform3D anchor = new Transform3D();
      followed.get(anchor);
      if (!turnsToo) {
        Vector3d place = new Vector3d();
        anchor.get(place);
        anchor.set(place);
      } else {
        anchor.setRotation(headingOf(anchor));
      }
      viewpoint.setAnchor(anchor);
    }
  }

  /** The turn about the vertical alone: the eye does not roll with a tilted body. */
  private static Matrix3d headingOf(Transform3D pose) {
    Matrix3d turn = new Matrix3d();
    pose.get(turn);
    Matrix3d level = new Matrix3d();
    level.rotY(Math.atan2(turn.m02, turn.m00));
    return level;
  }

  private synchronized void showEye() {
    viewpoint.get(eye);
    if (!eye.equals(eyeShown)) {
      eyeShown.set(eye);
      universe.eye().setTransform(eye);
    }
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
    figures.clear();
    synchronized (this) {
      followed = null;
    }
  }
}
