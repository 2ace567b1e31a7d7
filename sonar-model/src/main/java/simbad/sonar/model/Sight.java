package simbad.sonar.model;

import java.util.OptionalDouble;
import simbad.sonar.check.Checks;

/**
 * What the nominal model makes of one obstacle from one pose.
 *
 * @param centreDistanceM from the sensor to the obstacle's centre, metres
 * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
 * @param thresholdM at that bearing, metres
 * @param nearestM distance to the nearest point of the outline in the cone, metres; empty when the
 *     cone holds none
 * @param echoProbability that this obstacle answers a ping, in [0, 1]
 */
public record Sight(
    double centreDistanceM,
    double bearingRad,
    double thresholdM,
    OptionalDouble nearestM,
    double echoProbability) {
  /** Refuses what is no number. */
  public Sight {
    Checks.number("centreDistanceM", centreDistanceM);
    Checks.number("bearingRad", bearingRad);
    Checks.number("thresholdM", thresholdM);
    Checks.finite("nearestM", nearestM);
    Checks.share("echoProbability", echoProbability);
  }
}
