package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The floor answers at two fixed ranges, as two joints of its tiles do, when nothing nearer does.
 *
 * @param near the nearer one
 * @param apartM how much farther the other one is, metres
 * @param fartherShare of the pings that the other one answers, in [0, 1]
 */
public record TwoFloorEchoes(FloorEcho near, double apartM, double fartherShare)
    implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public TwoFloorEchoes {
    Checks.notNegative("apartM", apartM);
    Checks.share("fartherShare", fartherShare);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    near.add(moment, arrivals);
    arrivals.add(near.rangeM() + apartM, near.spreadM(), fartherShare);
  }

  @Override
  public boolean hangsOnPose() {
    return false;
  }
}
