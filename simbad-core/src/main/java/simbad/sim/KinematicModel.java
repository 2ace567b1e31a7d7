package simbad.sim;

import java.text.DecimalFormat;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;

/** How an agent moves in a step. Programs may derive their own. */
public abstract class KinematicModel {
  /** Creates a model. */
  public KinematicModel() {}

  /**
   * Computes the displacement of a step.
   *
   * @param elapsedSecond how long the step takes, simulated seconds
   * @param rotation how the agent is turned at the start of the step
   * @param instantTranslation receives the displacement in the world frame, metres
   * @param instantRotation receives the turn, radians; only y counts
   */
  protected abstract void update(
      double elapsedSecond,
      Transform3D rotation,
      Vector3d instantTranslation,
      Vector3d instantRotation);

  /** Stops. */
  protected abstract void reset();

  /** Describes the model and its velocities. */
  protected abstract String toString(DecimalFormat format);
}
