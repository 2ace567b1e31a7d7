package simbad.experiments.motion;

import java.nio.file.Path;
import java.text.DecimalFormat;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.motion.LiveMotion;
import simbad.motion.MotionChain;
import simbad.motion.format.DiagnosedMotion;
import simbad.sim.DefaultKinematic;
import simbad.sonar.format.DataFormatException;

/**
 * Moves a robot as a diagnosis found that a real one moves: late, a little slow, turning by itself.
 * Any agent takes one by {@code setKinematicModel} and goes on to set its velocities as before.
 *
 * <p>A step goes straight along the heading that it began with and turns afterwards, as that of
 * Simbad's own model does: with a robot that does what it is told both move alike to the bit.
 */
public final class DiagnosedKinematic extends DefaultKinematic {
  private final LiveMotion motion;

  /**
   * Creates a model of a robot that stands.
   *
   * @param chain how it moves
   */
  public DiagnosedKinematic(MotionChain chain) {
    motion = new LiveMotion(chain);
  }

  /**
   * Reads what a diagnosis left.
   *
   * @param diagnosis the folder that simbad diagnose made of a motion folder
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static DiagnosedKinematic read(Path diagnosis) throws DataFormatException {
    return new DiagnosedKinematic(DiagnosedMotion.read(diagnosis));
  }

  @Override
  protected void reset() {
    super.reset();
    motion.stop();
  }

  @Override
  protected void update(
      double elapsedSecond,
      Transform3D rotation,
      Vector3d instantTranslation,
      Vector3d instantRotation) {
    motion.step(getTranslationalVelocity(), getRotationalVelocity(), elapsedSecond);
    instantTranslation.set(motion.wayM(), 0, 0);
    rotation.transform(instantTranslation);
    instantRotation.set(0, motion.turnRad(), 0);
  }

  @Override
  protected String toString(DecimalFormat format) {
    return "DiagnosedKinematic\n" + super.toString(format);
  }
}
