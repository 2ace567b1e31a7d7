package simbad.sonar.sensing;

import java.util.OptionalDouble;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Placement;

/**
 * Where the first obstacle stood at a reading: on a turntable, or moved by hand.
 *
 * @param xM metres; empty where it is the scene's
 * @param zM metres; empty where it is the scene's
 * @param turnRad counter-clockwise, radians; empty where it is the scene's
 */
public record MovedObstacle(OptionalDouble xM, OptionalDouble zM, OptionalDouble turnRad) {
  /** Refuses what is no number. */
  public MovedObstacle {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.finite("turnRad", turnRad);
  }

  /** It stood as the scene says. */
  public static final MovedObstacle UNMOVED =
      new MovedObstacle(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());

  /** Returns how it stood, given how the scene has it. */
  public Placement placement(Placement scenes) {
    return new Placement(
        xM.orElse(scenes.xM()), zM.orElse(scenes.zM()), turnRad.orElse(scenes.turnRad()));
  }
}
