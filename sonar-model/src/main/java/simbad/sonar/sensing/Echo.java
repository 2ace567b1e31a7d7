package simbad.sonar.sensing;

/**
 * A ping that was answered.
 *
 * @param rangeM what the sensor says the distance to the answering surface is, in metres; finite,
 *     at least 0
 */
public record Echo(double rangeM) implements Reading {
  /** Checks the range. */
  public Echo {
    if (!(rangeM >= 0 && rangeM < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("rangeM = " + rangeM + " is not in [0, infinity)");
    }
  }
}
