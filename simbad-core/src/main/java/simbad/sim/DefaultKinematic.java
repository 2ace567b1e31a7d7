package simbad.sim;

import java.text.DecimalFormat;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.kernel.motion.BodyDrive;
import simbad.kernel.motion.DriveStep;

/** Moves along the heading with one velocity and turns with another. */
public class DefaultKinematic extends KinematicModel {
  private final BodyDrive drive = new BodyDrive();
  private final DriveStep step = new DriveStep();

  /** Creates a model at rest; for models that let the robot move otherwise than it is told. */
  protected DefaultKinematic() {}

  @Override
  protected void reset() {
    drive.stop();
  }

  @Override
  protected void update(
      double elapsedSecond,
      Transform3D rotation,
      Vector3d instantTranslation,
      Vector3d instantRotation) {
    drive.advance(elapsedSecond, step);
    Displacements.turnInto(step, rotation, instantTranslation, instantRotation);
  }

  /** Sets the turning rate, radians per second, counter-clockwise. */
  public final void setRotationalVelocity(double velocity) {
    drive.setTurn(velocity);
  }

  /** Sets the velocity along the heading, metres per second. */
  public final void setTranslationalVelocity(double velocity) {
    drive.setSpeed(velocity);
  }

  /** Returns the turning rate, radians per second. */
  public final double getRotationalVelocity() {
    return drive.turnRadPerS();
  }

  /** Returns the velocity along the heading, metres per second. */
  public final double getTranslationalVelocity() {
    return drive.speedMPerS();
  }

  @Override
  protected String toString(DecimalFormat format) {
    return "DefaultKinematic\ntranslational velocity: "
        + format.format(getTranslationalVelocity())
        + " m/s\nrotational velocity: "
        + format.format(getRotationalVelocity())
        + " rad/s";
  }
}
