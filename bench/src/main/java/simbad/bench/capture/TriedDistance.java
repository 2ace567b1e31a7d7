package simbad.bench.capture;

import simbad.sonar.check.Checks;

/**
 * A distance that is to be tried.
 *
 * @param distanceM from the sensor to the obstacle's axis, metres, above 0
 * @param approach why
 */
public record TriedDistance(double distanceM, Approach approach) {
  /** Checks the distance. */
  public TriedDistance {
    Checks.positive("distanceM", distanceM);
  }
}
