package simbad.sonar.sensing;

import simbad.sonar.check.Checks;

/**
 * A ping that was answered.
 *
 * @param rangeM what the sensor says the distance to the answering surface is, in metres; finite,
 *     at least 0
 */
public record Echo(double rangeM) implements Reading {
  /** Checks the range. */
  public Echo {
    Checks.notNegative("rangeM", rangeM);
  }
}
