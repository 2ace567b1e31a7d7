package simbad.sonar.effect;

/**
 * Every echo is weaker or stronger by the same level.
 *
 * @param gainDb decibels; 0 is neutral
 */
public record LevelGain(double gainDb) implements LevelChange {
  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return gainDb;
  }
}
