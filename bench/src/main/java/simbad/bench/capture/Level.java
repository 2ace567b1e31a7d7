package simbad.bench.capture;

import simbad.sonar.check.Checks;

/**
 * What was heard at one distance.
 *
 * @param distanceM from the sensor to the obstacle's axis, metres
 * @param approach why it was tried
 * @param heard how many pings had an echo, in [0, pings]
 * @param pings how many there were
 */
public record Level(double distanceM, Approach approach, int heard, int pings) {
  /** Checks the distance and the counts. */
  public Level {
    Checks.notNegative("distanceM", distanceM);
    if (heard < 0 || heard > pings) {
      throw new IllegalArgumentException("heard = " + heard + " is not in [0, " + pings + "]");
    }
  }

  boolean isAt(double otherM, Approach other) {
    return approach == other && distanceM == otherM;
  }

  Level with(boolean echo) {
    return new Level(distanceM, approach, heard + (echo ? 1 : 0), pings + 1);
  }
}
