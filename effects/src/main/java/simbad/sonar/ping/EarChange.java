package simbad.sonar.ping;

/**
 * What ears know of one obstacle under the level law: a calibration of the set-up. {@link
 * LevelEars} counts with it; by itself it adds nothing to an excess.
 */
interface EarChange extends LevelChange, ObstacleChange {
  @Override
  default boolean changesGeometry() {
    return true;
  }

  @Override
  default double addedDb(LevelEars ears, Geometry geometry, int line) {
    return 0;
  }
}
