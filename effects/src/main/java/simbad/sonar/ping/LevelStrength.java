package simbad.sonar.ping;

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
    implements EarChange {}
