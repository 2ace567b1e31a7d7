package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Every echo is weaker or stronger by the same level.
 *
 * @param gainDb decibels; 0 is neutral
 */
public record LevelGain(double gainDb) implements LevelChange {
  /** Checks the figure; NaN is refused. */
  public LevelGain {
    Checks.finite("gainDb", gainDb);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return gainDb;
  }
}
