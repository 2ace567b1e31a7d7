package simbad.sonar.level;

/**
 * A beam as a curve.
 *
 * @param twoWayDb decibels, out and back, by degrees off the axis to either side
 */
public record CurveBeam(Curve twoWayDb) implements Beam {
  @Override
  public double twoWayEnergy(double along, double across) {
    double offAxisDeg = Math.toDegrees(Math.atan2(Math.abs(across), along));
    return Decibels.energy(twoWayDb.at(offAxisDeg));
  }

  @Override
  public double greatestEnergy() {
    return Decibels.energy(twoWayDb.greatest());
  }

  @Override
  public double axisDb() {
    return twoWayDb.at(0);
  }
}
