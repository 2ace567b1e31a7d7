package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;

/**
 * Echoes grow weaker or stronger while a log is taken: a battery, a transmitter that warms up. No
 * effect's form: what is likelier with it has no name.
 *
 * @param firstDb added at the first ping, decibels; 0 is neutral
 * @param halfwayDb added after half of the time, straight between; 0 is neutral
 * @param lastDb added at the last ping; 0 is neutral
 * @param durationS time between the two, seconds, positive
 */
public record LevelDrift(double firstDb, double halfwayDb, double lastDb, double durationS)
    implements LevelChange {
  /** Checks the figures; NaN is refused. */
  public LevelDrift {
    Checks.finite("firstDb", firstDb);
    Checks.finite("halfwayDb", halfwayDb);
    Checks.finite("lastDb", lastDb);
    Checks.positive("durationS", durationS);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    double time = geometry.sinceStartS(line / geometry.obstacles()) / durationS;
    return time < 0.5
        ? firstDb + 2 * time * (halfwayDb - firstDb)
        : halfwayDb + (2 * Math.min(1, time) - 1) * (lastDb - halfwayDb);
  }
}
