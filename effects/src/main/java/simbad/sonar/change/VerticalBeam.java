package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.EchoChange;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.RangeChange;

/**
 * What answers is over or under the sensor's axis: its range is the slanting way, and from near by
 * it is out of the beam.
 *
 * @param heightM from the axis to what answers, metres, at least 0; 0 is neutral
 * @param halfAngleRad how far up and down the beam reaches, in (0, pi/2]; pi/2 loses nothing
 * @param softM over which distance the beam's edge is passed, metres; positive
 */
public record VerticalBeam(double heightM, double halfAngleRad, double softM)
    implements RangeChange, EchoChange {
  /** Checks the figures; NaN is refused. */
  public VerticalBeam {
    Checks.notNegative("heightM", heightM);
    Checks.positive("softM", softM);
    if (!(halfAngleRad > 0 && halfAngleRad <= Math.PI / 2)) {
      throw new IllegalArgumentException("halfAngleRad = " + halfAngleRad + " is not in (0, pi/2]");
    }
  }

  /** The way is slanting before it is measured, in whatever scale. */
  @Override
  public int order() {
    return -1;
  }

  @Override
  public double meanM(double rangeM) {
    return heightM == 0 ? rangeM : Math.sqrt(rangeM * rangeM + heightM * heightM);
  }

  /** The level way of a slanting one; 0 for one that is shorter than the height. */
  @Override
  public double rangeM(double meanM) {
    return heightM == 0 ? meanM : Math.sqrt(Math.max(0, meanM * meanM - heightM * heightM));
  }

  @Override
  public double share(Geometry geometry, int line) {
    if (heightM == 0 || halfAngleRad == Math.PI / 2) {
      return 1;
    }
    double beyondM = geometry.nearestM(line) - heightM / Math.tan(halfAngleRad);
    return 1 / (1 + Math.exp(-beyondM / softM));
  }
}
