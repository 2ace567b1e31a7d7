package simbad.sonar.effect;

import simbad.sonar.level.Beam;
import simbad.sonar.level.PistonBeam;

/**
 * The beam is that of a wider or narrower piston: a piston of twice the radius hears half as far
 * off the axis.
 *
 * @param factor of the radius times the wavenumber; 1 is neutral
 */
public record LevelAperture(double factor) implements LevelChange {
  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    if (factor == 1 || !(ears.law().beam() instanceof PistonBeam believed)) {
      return 0;
    }
    Beam actual = believed.widened(factor);
    return ears.beamDb(actual, geometry, line) - ears.beamDb(believed, geometry, line);
  }
}
