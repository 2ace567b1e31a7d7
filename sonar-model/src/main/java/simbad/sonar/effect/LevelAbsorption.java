package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The air takes more of an echo than believed, both ways.
 *
 * @param addedDbPerM one way, decibels per metre; 0 is neutral, negative where it takes less
 */
public record LevelAbsorption(double addedDbPerM) implements LevelChange {
  /** Checks the figure; NaN is refused. */
  public LevelAbsorption {
    Checks.finite("addedDbPerM", addedDbPerM);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return -2 * addedDbPerM * geometry.centreDistanceM(line);
  }
}
