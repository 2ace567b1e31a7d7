package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * An echo is read too near, by an amount that depends on the reading before, when a reflection of
 * the ping before comes first.
 *
 * @param share of the echoes after an echo, in [0, 1]; 0 is neutral
 * @param ownFactor what the echo's own range is multiplied by
 * @param beforeFactor what the reading before is multiplied by and added
 * @param shiftM what is taken from the sum, metres
 * @param spreadM standard deviation of that, metres
 */
public record NearerByPrevious(
    double share, double ownFactor, double beforeFactor, double shiftM, double spreadM)
    implements MixtureChange {
  private static final double LEAST_RANGE_M = 0.02;

  /** Checks the figures; NaN is refused. */
  public NearerByPrevious {
    Checks.share("share", share);
    Checks.finite("ownFactor", ownFactor);
    Checks.finite("beforeFactor", beforeFactor);
    Checks.finite("shiftM", shiftM);
    Checks.notNegative("spreadM", spreadM);
  }

  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    Mixture before = moment.before();
    if (share == 0 || before.size() == 0) {
      return;
    }
    int parts = mixture.size();
    for (int part = 0; part < parts; part++) {
      double moved = 0;
      for (int other = 0; other < before.size(); other++) {
        double range =
            ownFactor * mixture.meanM(part) + beforeFactor * before.meanM(other) - shiftM;
        if (range > LEAST_RANGE_M && range < mixture.meanM(part)) {
          double more = share * before.share(other);
          mixture.add(range, deviationM(mixture, part, before, other), more * mixture.share(part));
          moved += more;
        }
      }
      mixture.scaleShare(part, 1 - Math.min(1, moved));
    }
  }

  private double deviationM(Mixture mixture, int part, Mixture before, int other) {
    double own = ownFactor * mixture.deviationM(part);
    double former = beforeFactor * before.deviationM(other);
    return Math.sqrt(own * own + former * former + spreadM * spreadM);
  }
}
