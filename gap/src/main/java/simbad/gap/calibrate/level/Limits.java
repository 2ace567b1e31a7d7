package simbad.gap.calibrate.level;

import simbad.gap.fit.Fold;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SonarSpec;

/**
 * Between which distances a sensor hears. What a scene says of that is often what somebody once
 * read in a data sheet; a reference whose readings lie beyond it knows better.
 *
 * @param leastM nearer echoes are not heard, metres
 * @param mostM further ones are not, metres
 */
record Limits(double leastM, double mostM) {
  /** Fewer readings beyond a limit are strays. */
  private static final int LEAST_READINGS = 3;

  /** A reading so near to an obstacle's nearest point is its echo. */
  private static final double NEAR_M = 0.1;

  /** Beyond the farthest echo of a reference: what is heard there was not tried. */
  private static final double MARGIN = 1.1;

  /**
   * Reads a reference.
   *
   * @param geometry of it
   * @param sensor as believed
   * @param fold the pings that count
   */
  static Limits of(Geometry geometry, SonarSpec sensor, Fold fold) {
    PingLog log = geometry.log();
    int nearer = 0;
    int farther = 0;
    double least = sensor.minRangeM();
    double most = sensor.maxRangeM();
    for (int line = 0; line < log.size() * geometry.obstacles(); line++) {
      int ping = line / geometry.obstacles();
      double read = log.rangeM(ping);
      double nearest = geometry.nearestM(line);
      if (fold.holds(ping) && log.echo(ping) && Math.abs(nearest - read) < NEAR_M) {
        if (Math.max(read, nearest) < sensor.minRangeM()) {
          nearer++;
          least = Math.min(least, nearest);
        }
        if (Math.min(read, nearest) > sensor.maxRangeM()) {
          farther++;
          most = Math.max(most, MARGIN * nearest);
        }
      }
    }
    return new Limits(
        nearer < LEAST_READINGS ? sensor.minRangeM() : least,
        farther < LEAST_READINGS ? sensor.maxRangeM() : most);
  }

  /** Returns a sensor that hears between these. */
  SonarSpec of(SonarSpec sensor) {
    return sensor.withRange(leastM, mostM);
  }
}
