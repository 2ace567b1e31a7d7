package simbad.sim;

import java.text.DecimalFormat;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.kernel.motion.DifferentialDrive;
import simbad.kernel.motion.DriveStep;

/** Moves as two driven wheels on one axle do. */
public class DifferentialKinematic extends KinematicModel {
  private final DifferentialDrive drive;
  private final DriveStep step = new DriveStep();

  /**
   * Creates a model at rest.
   *
   * @param wheelDistance distance between the wheels, metres; above 0
   */
  public DifferentialKinematic(double wheelDistance) {
    drive = new DifferentialDrive(wheelDistance);
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

  @Override
  protected void reset() {
    drive.stop();
  }

  @Override
  protected String toString(DecimalFormat format) {
    return "DifferentialKinematic\nleft velocity: "
        + format.format(getLeftVelocity())
        + " m/s\nright velocity: "
        + format.format(getRightVelocity())
        + " m/s";
  }

  /** Sets the left wheel's velocity over ground, metres per second. */
  public void setLeftVelocity(double velocity) {
    drive.setLeft(velocity);
  }

  /** Sets the right wheel's velocity over ground, metres per second. */
  public void setRightVelocity(double velocity) {
    drive.setRight(velocity);
  }

  /** Sets both wheels' velocities over ground, metres per second. */
  public void setWheelsVelocity(double left, double right) {
    setLeftVelocity(left);
    setRightVelocity(right);
  }

  /** Returns the left wheel's velocity, metres per second. */
  public double getLeftVelocity() {
    return drive.leftMPerS();
  }

  /** Returns the right wheel's velocity, metres per second. */
  public double getRightVelocity() {
    return drive.rightMPerS();
  }
}
