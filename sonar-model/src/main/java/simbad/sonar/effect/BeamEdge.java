package simbad.sonar.effect;

import simbad.sonar.check.Checks;
import simbad.sonar.scene.SonarSpec;

/**
 * The cone's border is soft: the chance of an echo falls across it as a logistic curve, and beyond
 * it something is heard still. A calibration of the set-up.
 *
 * @param softRad the angle over which the chance falls from 1/2 to 1/(1+e); 0 is neutral
 */
public record BeamEdge(double softRad) implements SensorChange, EchoChange {
  /** So many soft angles beyond the border, with a chance under 2 %, the cone ends. */
  private static final double REACH = 4;

  /** Checks the figure; NaN is refused. */
  public BeamEdge {
    Checks.notNegative("softRad", softRad);
  }

  @Override
  public SonarSpec apply(SonarSpec believed) {
    double halfAngle = believed.coneHalfAngleRad() + REACH * softRad;
    return softRad == 0 ? believed : believed.withCone(Math.min(Math.PI, halfAngle));
  }

  @Override
  public double share(Geometry geometry, int line) {
    // A cone that has become the whole plane has no border.
    if (softRad == 0 || geometry.coneHalfAngleRad() == Math.PI) {
      return 1;
    }
    double border = geometry.coneHalfAngleRad() - REACH * softRad;
    return 1 / (1 + Math.exp((geometry.outlineOffAxisRad(line) - border) / softRad));
  }
}
