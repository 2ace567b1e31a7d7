package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The beam is that of a wider or narrower piston: a piston of twice the radius hears half as far
 * off the axis.
 *
 * @param factor of the radius times the wavenumber; 1 is neutral
 */
public record LevelAperture(double factor) implements LevelChange {
  /** Checks the figure; NaN is refused. */
  public LevelAperture {
    Checks.positive("factor", factor);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return factor == 1 ? 0 : ears.widenedDb(factor, geometry, line);
  }
}
