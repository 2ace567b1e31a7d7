package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * What a scene says of its sonar; lengths in metres, times in seconds.
 *
 * @param name its type
 * @param halfAngleRad half the opening of the cone
 * @param minRangeM the nearest distance that is read
 * @param maxRangeM the furthest distance that is read
 * @param mountHeightM above the floor
 * @param soundSpeedMPerS as the conversion assumes it
 * @param resolutionM the step of the readings
 * @param rangeNoiseM standard deviation of a range
 * @param missRate the share of echoes that are missed near by
 * @param edgeWidthM the scale of the logistic fall at the threshold
 * @param periodS the time between pings
 */
public record Sensor(
    String name,
    double halfAngleRad,
    double minRangeM,
    double maxRangeM,
    double mountHeightM,
    double soundSpeedMPerS,
    double resolutionM,
    double rangeNoiseM,
    double missRate,
    double edgeWidthM,
    double periodS) {
  /** Refuses what is no such thing. */
  public Sensor {
    Checks.notNegative("half angle", halfAngleRad);
    Checks.notNegative("least range", minRangeM);
    Checks.notNegative("greatest range", maxRangeM);
    Checks.finite("height", mountHeightM);
    Checks.positive("speed of sound", soundSpeedMPerS);
    Checks.notNegative("resolution", resolutionM);
    Checks.notNegative("noise of ranges", rangeNoiseM);
    Checks.share("miss rate", missRate);
    Checks.notNegative("width of the edge", edgeWidthM);
    Checks.notNegative("period", periodS);
  }
}
