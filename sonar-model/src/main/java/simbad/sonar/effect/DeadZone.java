package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Near echoes are lost.
 *
 * @param endM distance up to which they are, metres; 0 is neutral
 * @param softM width of the border, metres; 0 for a sharp one
 */
public record DeadZone(double endM, double softM) implements EchoChange {
  /** Checks the figures; NaN is refused. */
  public DeadZone {
    Checks.notNegative("endM", endM);
    Checks.notNegative("softM", softM);
  }

  @Override
  public double share(Geometry geometry, int line) {
    double beyond = geometry.nearestM(line) - endM;
    if (endM <= 0) {
      return 1;
    }
    return softM > 0 ? 1 / (1 + Math.exp(-beyond / softM)) : beyond >= 0 ? 1 : 0;
  }
}
