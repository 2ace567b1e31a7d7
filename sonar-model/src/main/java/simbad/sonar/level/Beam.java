package simbad.sonar.level;

/**
 * How a sensor's sender and receiver together weaken an echo off the axis: both ways in one figure.
 *
 * <p>Directions are given by coordinates along the axis and across it, of any length, so that none
 * has to be turned into an angle. Immutable.
 */
public sealed interface Beam permits PistonBeam, CurveBeam {
  /**
   * Returns by what an echo's energy is multiplied.
   *
   * @param along the axis, positive ahead
   * @param across the axis, either sign; in the unit of the other
   * @return at least 0, and 1 at the axis of a piston; that of the axis where both are 0
   */
  double twoWayEnergy(double along, double across);

  /** Returns the greatest such ratio of all directions. */
  double greatestEnergy();

  /**
   * Returns the same in decibels.
   *
   * @param offAxisRad angle off the axis, either sign
   * @return negative infinity where nothing is heard
   */
  default double twoWayDb(double offAxisRad) {
    return Decibels.level(twoWayEnergy(Math.cos(offAxisRad), Math.sin(offAxisRad)));
  }

  /** Returns the level at the axis in decibels. */
  double axisDb();

  /** Returns a beam that hears alike in all directions. */
  static Beam everywhere() {
    return new CurveBeam(Curve.constant(0));
  }
}
