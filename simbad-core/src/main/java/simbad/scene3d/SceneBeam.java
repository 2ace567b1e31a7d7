package simbad.scene3d;

import javax.media.j3d.Node;
import javax.media.j3d.Shape3D;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import simbad.sonar.sensing.TransducerPoses;

/** One ray or cone, made as long as it has to be. */
final class SceneBeam {
  /** A transform must not flatten what it is applied to. */
  private static final double SHORTEST_M = 1e-4;

  private final Matrix3d turn = new Matrix3d();
  private final Vector3d start;
  private final double idleM;
  private final BeamLook idle;
  private final BeamLook hit;
  private final TransformGroup group = new TransformGroup();
  private final Shape3D body;
  private final Shape3D end;
  private boolean hitShown;
  private double lengthM;

  SceneBeam(TransducerPoses poses, int i, double idleM, BeamLook idle, BeamLook hit) {
    this.idleM = idleM;
    this.idle = idle;
    this.hit = hit;
    start = new Vector3d(poses.xM(i), poses.yM(i), poses.zM(i));
    point(new Vector3d(poses.directionX(i), poses.directionY(i), poses.directionZ(i)));
    body = idle.newBody();
    end = idle.newEnd();
    group.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
    group.addChild(body);
    group.addChild(end);
    stretch(idleM);
  }

  /** Turns +x to a direction, and y as far upwards as it goes. */
  private void point(Vector3d direction) {
    boolean steep = Math.abs(direction.y) > 0.9;
    Vector3d z = new Vector3d();
    z.cross(direction, steep ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0));
    z.normalize();
    Vector3d y = new Vector3d();
    y.cross(z, direction);
    turn.setColumn(0, direction);
    turn.setColumn(1, y);
    turn.setColumn(2, z);
  }

  Node node() {
    return group;
  }

  void showIdle() {
    show(false, idle, idleM);
  }

  void showEcho(double rangeM) {
    show(true, hit, rangeM);
  }

  private void show(boolean isHit, BeamLook wanted, double wantedM) {
    if (hitShown != isHit) {
      hitShown = isHit;
      body.setAppearance(wanted.bodyLook());
      end.setAppearance(wanted.endLook());
    }
    if (lengthM != wantedM) {
      stretch(wantedM);
    }
  }

  private void stretch(double newLengthM) {
    lengthM = newLengthM;
    group.setTransform(new Transform3D(turn, start, Math.max(SHORTEST_M, newLengthM)));
  }
}
