package simbad.sim;

import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.swing.SwingUtilities;
import javax.swing.event.MouseInputListener;
import javax.vecmath.Point3d;
import simbad.scene3d.Viewpoint;

/**
 * Moves the eye with the mouse: the left button turns it round a centre, the right one pans, the
 * middle one (or the left one with Alt) and the wheel zoom, a double click goes back.
 */
public class MouseOrbiter implements MouseInputListener {
  private static final double RAD_PER_PX = 0.01;

  /** Width of what one sees, as a share of the distance: twice the tangent of 22.5 degrees. */
  private static final double SHARE_SEEN = 0.83;

  private static final double ZOOM_PER_PX = 1.01;
  private static final double ZOOM_PER_NOTCH = 1.1;

  private final Canvas3D canvas;
  private final TransformGroup eye;
  private final Viewpoint viewpoint;
  private int x;
  private int y;

  /**
   * Listens to a canvas.
   *
   * @param canvas shows what the eye sees
   * @param transformGroup carries the eye; its transform may be read and written
   */
  public MouseOrbiter(Canvas3D canvas, TransformGroup transformGroup) {
    this(canvas, transformGroup, new Viewpoint());
    Transform3D start = new Transform3D();
    transformGroup.getTransform(start);
    viewpoint.look(start);
    listen();
  }

  /** Moves a viewpoint which somebody else hands to the eye, too. */
  MouseOrbiter(Canvas3D canvas, TransformGroup eye, Viewpoint viewpoint) {
    this.canvas = canvas;
    this.eye = eye;
    this.viewpoint = viewpoint;
  }

  final void listen() {
    canvas.addMouseListener(this);
    canvas.addMouseMotionListener(this);
    canvas.addMouseWheelListener(this::zoom);
  }

  /** Moves the eye by what the mouse has been dragged since the last event. */
  protected void processMouseEvent(MouseEvent event) {
    int right = event.getX() - x;
    int down = event.getY() - y;
    x = event.getX();
    y = event.getY();
    if (SwingUtilities.isRightMouseButton(event)) {
      double share = SHARE_SEEN / Math.max(1, canvas.getWidth());
      viewpoint.pan(-right * share, down * share);
    } else if (SwingUtilities.isMiddleMouseButton(event) || event.isAltDown()) {
      viewpoint.zoom(Math.pow(ZOOM_PER_PX, down));
    } else {
      viewpoint.orbit(-right * RAD_PER_PX, down * RAD_PER_PX);
    }
    integrateTransforms();
  }

  private void zoom(MouseWheelEvent event) {
    viewpoint.zoom(Math.pow(ZOOM_PER_NOTCH, event.getPreciseWheelRotation()));
    integrateTransforms();
  }

  /** Goes back to where the eye was at first. */
  public void resetView() {
    viewpoint.goHome();
    integrateTransforms();
  }

  /** Hands the eye its place. */
  protected synchronized void integrateTransforms() {
    Transform3D worldFromEye = new Transform3D();
    viewpoint.get(worldFromEye);
    eye.setTransform(worldFromEye);
  }

  /** Sets the point, metres, round which the eye turns. */
  public synchronized void setRotationCenter(Point3d center) {
    viewpoint.setCentre(center);
  }

  @Override
  public void mouseClicked(MouseEvent event) {
    if (event.getClickCount() == 2) {
      resetView();
    }
  }

  @Override
  public void mousePressed(MouseEvent event) {
    x = event.getX();
    y = event.getY();
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    // A drag has been followed all the way.
  }

  @Override
  public void mouseEntered(MouseEvent event) {
    // Only drags count.
  }

  @Override
  public void mouseExited(MouseEvent event) {
    // Only drags count.
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    processMouseEvent(event);
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    // Only drags count.
  }
}
