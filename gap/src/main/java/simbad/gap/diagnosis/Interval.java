package simbad.gap.diagnosis;

/**
 * An interval of numbers, both ends included.
 *
 * @param low not above high; may be negative infinity where the data do not bound it
 * @param high may be positive infinity
 */
public record Interval(double low, double high) {}
