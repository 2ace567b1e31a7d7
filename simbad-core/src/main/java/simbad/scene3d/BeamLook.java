package simbad.scene3d;

import java.util.OptionalDouble;
import javax.media.j3d.Appearance;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.LineStripArray;
import javax.media.j3d.PointArray;
import javax.media.j3d.Shape3D;
import javax.media.j3d.TriangleFanArray;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;

/**
 * What a beam of length 1 along +x consists of: its body, a line or a cone, and its far end, a
 * point or an arc. Shared by the beams of a sensor.
 *
 * @param body geometry of the body
 * @param end geometry of the far end
 * @param bodyLook how the body looks
 * @param endLook how the far end looks
 */
record BeamLook(GeometryArray body, GeometryArray end, Appearance bodyLook, Appearance endLook) {
  private static final Color3f HIT = new Color3f(0.9f, 0.1f, 0.1f);
  private static final int EDGES = 24;

  /** The look without an echo. */
  static BeamLook idle(Beams.Style style) {
    boolean cone = style.halfAngleRad().isPresent();
    return of(style, style.color(), cone ? 0.12f : 0.7f, 0.4f);
  }

  /** The look with an echo. */
  static BeamLook hit(Beams.Style style) {
    boolean cone = style.halfAngleRad().isPresent();
    return of(style, HIT, cone ? 0.22f : 0.6f, 0.9f);
  }

  private static BeamLook of(Beams.Style style, Color3f color, float body, float end) {
    OptionalDouble angle = style.halfAngleRad();
    Appearance stroke = Appearances.stroke(color, end, 2);
    return angle.isPresent()
        ? new BeamLook(
            cone(angle.getAsDouble()),
            arc(angle.getAsDouble()),
            Appearances.translucent(color, body),
            stroke)
        : new BeamLook(ray(), tip(), Appearances.stroke(color, body, 1.5f), stroke);
  }

  Shape3D newBody() {
    return changeable(new Shape3D(body, bodyLook));
  }

  Shape3D newEnd() {
    return changeable(new Shape3D(end, endLook));
  }

  private static Shape3D changeable(Shape3D shape) {
    shape.setCapability(Shape3D.ALLOW_APPEARANCE_WRITE);
    return shape;
  }

  private static GeometryArray ray() {
    LineStripArray line = new LineStripArray(2, GeometryArray.COORDINATES, new int[] {2});
    line.setCoordinate(1, new Point3d(1, 0, 0));
    return line;
  }

  private static GeometryArray tip() {
    PointArray point = new PointArray(1, GeometryArray.COORDINATES);
    point.setCoordinate(0, new Point3d(1, 0, 0));
    return point;
  }

  /** The cone's side; its base is left open, so that only two faces lie behind one another. */
  private static GeometryArray cone(double halfAngleRad) {
    int size = EDGES + 2;
    TriangleFanArray fan = new TriangleFanArray(size, GeometryArray.COORDINATES, new int[] {size});
    for (int i = 0; i <= EDGES; i++) {
      double around = 2 * Math.PI * i / EDGES;
      double across = Math.sin(halfAngleRad);
      fan.setCoordinate(
          i + 1,
          new Point3d(
              Math.cos(halfAngleRad), across * Math.sin(around), across * Math.cos(around)));
    }
    return fan;
  }

  /** The level arc at distance 1, from one side of the cone to the other. */
  private static GeometryArray arc(double halfAngleRad) {
    LineStripArray line =
        new LineStripArray(EDGES + 1, GeometryArray.COORDINATES, new int[] {EDGES + 1});
    for (int i = 0; i <= EDGES; i++) {
      double angle = halfAngleRad * (2.0 * i / EDGES - 1);
      line.setCoordinate(i, new Point3d(Math.cos(angle), 0, Math.sin(angle)));
    }
    return line;
  }
}
