package simbad.sonar.effect;

import java.util.Optional;
import simbad.sonar.level.StrengthTable;

/**
 * How strongly an obstacle answers, by the bearing of the sensor: a calibration of the set-up,
 * which counts under the level law only.
 *
 * @param only label of the obstacle; empty for all
 * @param strengthDb by bearing, decibels
 * @param deviationDb how far that may be off, by bearing; nowhere below 0
 * @param withApertureDb by bearing, how far it is off where the aperture is too wide by one of its
 *     deviations: the two are known together better than apart
 */
public record LevelStrength(
    Optional<String> only,
    StrengthTable strengthDb,
    StrengthTable deviationDb,
    StrengthTable withApertureDb)
    implements LevelChange, ObstacleChange {
  @Override
  public boolean changesGeometry() {
    return true;
  }

  /** It is what the ears know, and adds nothing to it. */
  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return 0;
  }
}
