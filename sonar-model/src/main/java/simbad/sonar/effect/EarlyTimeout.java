package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Far echoes are lost.
 *
 * @param startM distance from which they are, metres; infinity is neutral
 * @param softM width of the border, metres; 0 for a sharp one
 */
public record EarlyTimeout(double startM, double softM) implements EchoChange {
  /** Checks the figures; NaN is refused. */
  public EarlyTimeout {
    Checks.notNegativeOrInfinite("startM", startM);
    Checks.notNegative("softM", softM);
  }

  @Override
  public double share(Geometry geometry, int line) {
    if (startM == Double.POSITIVE_INFINITY) {
      return 1;
    }
    double beyond = geometry.nearestM(line) - startM;
    return softM > 0 ? 1 / (1 + Math.exp(beyond / softM)) : beyond <= 0 ? 1 : 0;
  }
}
