package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The floor answers at a fixed range when nothing nearer does.
 *
 * @param rangeM metres
 * @param spreadM standard deviation of that range, metres
 * @param share of the pings that the floor answers, in [0, 1]; 0 is neutral
 */
public record FloorEcho(double rangeM, double spreadM, double share) implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public FloorEcho {
    Checks.notNegative("rangeM", rangeM);
    Checks.notNegative("spreadM", spreadM);
    Checks.share("share", share);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    arrivals.add(rangeM, spreadM, share);
  }

  @Override
  public boolean hangsOnPose() {
    return false;
  }
}
