package simbad.bench.capture;

/**
 * A distance that is to be tried.
 *
 * @param distanceM from the sensor to the obstacle's axis, metres
 * @param approach why
 */
public record Probe(double distanceM, Approach approach) {}
