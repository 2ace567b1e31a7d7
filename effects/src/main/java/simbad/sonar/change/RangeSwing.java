package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.RangeChange;

/**
 * Ranges swing to and fro with the time: a mast or an obstacle that sways. No effect's form: what
 * is likelier with it has no name.
 *
 * @param sineM by how much they are longer a quarter of a period after the first ping, metres; 0 is
 *     neutral
 * @param cosineM the same at the first ping; 0 is neutral
 * @param periodS of the swing, seconds, positive
 */
public record RangeSwing(double sineM, double cosineM, double periodS) implements RangeChange {
  /** Checks the figures; NaN is refused. */
  public RangeSwing {
    Checks.finite("sineM", sineM);
    Checks.finite("cosineM", cosineM);
    Checks.positive("periodS", periodS);
  }

  @Override
  public RangeChange at(Geometry geometry, int ping) {
    double angleRad = 2 * Math.PI * geometry.sinceStartS(ping) / periodS;
    return new RangeOffset(sineM * Math.sin(angleRad) + cosineM * Math.cos(angleRad));
  }

  /** Returns how far ranges go to either side, metres. */
  public double amplitudeM() {
    return Math.hypot(sineM, cosineM);
  }

  @Override
  public int order() {
    return 1;
  }
}
