package simbad.sonar.ping;

import simbad.sonar.level.LevelLaw;

/**
 * The echo, under the level law, of a thing that is not in the scene: as strong as it sends back,
 * in the direction and from the distance that it has at each ping.
 */
public final class LevelEcho {
  private LevelEcho() {}

  /**
   * Adds it to what arrives; nothing where the sensor hears by thresholds or not so far.
   *
   * @param moment the ping
   * @param arrivals takes it
   * @param toX where it comes from, from the sensor, along x, metres
   * @param toZ the same along z
   * @param strengthDb how much is sent back, decibels as of targets
   */
  public static void add(
      Moment moment, Arrivals arrivals, double toX, double toZ, double strengthDb) {
    Geometry geometry = moment.geometry();
    LevelEars ears = geometry.ears();
    double distance = Math.sqrt(toX * toX + toZ * toZ);
    if (ears == null || !ears.isInRange(distance)) {
      return;
    }
    double heading = geometry.headingRad(moment.ping());
    double ahead = toX * Math.cos(heading) - toZ * Math.sin(heading);
    double left = -toX * Math.sin(heading) - toZ * Math.cos(heading);
    if (ahead <= 0) {
      return;
    }
    double offAxis = Math.atan2(left, ahead);
    double excess = ears.excessDb(strengthDb, offAxis, distance);
    double deviation = ears.deviationDb(offAxis, distance);
    double chance = QuickNormal.atMost(excess, deviation);
    LevelLaw law = ears.law();
    arrivals.add(
        ears.rangeScale() * distance + law.walkM().at(excess),
        law.noiseM().at(excess),
        chance * ears.heardShare());
  }
}
