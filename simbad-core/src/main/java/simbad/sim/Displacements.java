package simbad.sim;

import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.kernel.motion.DriveStep;

/** Turns the kernel's displacement, in the robot's frame, into Java 3D vectors in the world's. */
final class Displacements {
  private Displacements() {}

  static void turnInto(DriveStep step, Transform3D rotation, Vector3d translation, Vector3d turn) {
    translation.set(step.forwardM(), 0, -step.leftM());
    rotation.transform(translation);
    turn.set(0, step.turnRad(), 0);
  }
}
