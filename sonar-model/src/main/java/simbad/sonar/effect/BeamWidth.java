package simbad.sonar.effect;

import simbad.sonar.check.Checks;
import simbad.sonar.scene.SonarSpec;

/**
 * The cone is wider or narrower than believed.
 *
 * @param addedRad to its half angle; 0 is neutral
 */
public record BeamWidth(double addedRad) implements SensorChange {
  private static final double LEAST_RAD = 1e-3;

  /** Checks the figure; NaN is refused. */
  public BeamWidth {
    Checks.finite("addedRad", addedRad);
  }

  @Override
  public SonarSpec apply(SonarSpec believed) {
    double halfAngle = believed.coneHalfAngleRad() + addedRad;
    return believed.withCone(Math.max(LEAST_RAD, Math.min(Math.PI, halfAngle)));
  }
}
