package simbad.blindworld.wave;

import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Pose;

/**
 * A target that hangs and swings about its place.
 *
 * @param target at rest
 * @param swingXM the most by which it swings, to the right
 * @param swingZM down the page
 * @param periodS of its swing
 */
public record Swaying(Target target, double swingXM, double swingZM, double periodS)
    implements Reflector {
  /** Refuses what is no such thing. */
  public Swaying {
    Checks.finite("swing", swingXM);
    Checks.finite("swing", swingZM);
    Checks.positive("period", periodS);
  }

  @Override
  public Trace arrivals(Pose pose, Medium medium, double tS) {
    double now = StrictMath.sin(2 * Math.PI * tS / periodS);
    return target.moved(swingXM * now, swingZM * now).arrivals(pose, medium, tS);
  }
}
