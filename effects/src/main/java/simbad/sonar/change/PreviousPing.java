package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.ArrivalChange;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.Moment;

/**
 * An echo of the ping before is taken for one of this ping, where it comes before this one's.
 *
 * @param share of the pings after an echo, in [0, 1]; 0 is neutral
 * @param factor what the reading before is multiplied by
 * @param shiftM what is taken from it then, metres
 * @param spreadM standard deviation of that, metres
 */
public record PreviousPing(double share, double factor, double shiftM, double spreadM)
    implements ArrivalChange {
  /** A ghost that is this near cannot be told from the ping itself. */
  private static final double LEAST_RANGE_M = 0.02;

  /** Checks the figures; NaN is refused. */
  public PreviousPing {
    Checks.share("share", share);
    Checks.finite("factor", factor);
    Checks.finite("shiftM", shiftM);
    Checks.notNegative("spreadM", spreadM);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    if (share == 0) {
      return;
    }
    Mixture before = moment.before();
    for (int part = 0; part < before.size(); part++) {
      double range = before.meanM(part) * factor - shiftM;
      if (range > LEAST_RANGE_M) {
        double deviation = Deviations.together(spreadM, factor * before.deviationM(part));
        arrivals.add(range, deviation, share * before.share(part));
      }
    }
  }

  @Override
  public boolean hangsOnPose() {
    return false;
  }
}
