package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;

/**
 * Echoes are stronger or weaker from ping to ping by more than they are known to be: wind, what
 * trembles, an amplifier that does. No effect's form: what is likelier with it has no name.
 *
 * @param meanDb added to all, decibels; 0 is neutral
 * @param scatterDb standard deviation, decibels, at least 0; 0 is neutral
 */
public record LevelScatter(double meanDb, double scatterDb) implements LevelChange {
  /** Checks the figure; NaN is refused. */
  public LevelScatter {
    Checks.finite("meanDb", meanDb);
    Checks.notNegative("scatterDb", scatterDb);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return meanDb;
  }
}
