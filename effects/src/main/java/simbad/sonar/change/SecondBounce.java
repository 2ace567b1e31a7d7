package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * The echo of the ping before goes to and fro once more between a plate and the sensor, and comes
 * before this ping's own. Where a ping follows the reading before after a pause, it is read at
 * twice the own range less the reading before and less what sound does in the pause.
 *
 * @param share of the echoes after an echo, in [0, 1]; 0 is neutral
 * @param shiftM how far sound goes and comes back in the pause, metres
 * @param spreadM standard deviation of that, metres
 * @param leastM from which range on the sensor listens, metres: it is deaf while its own ping dies
 *     away
 */
public record SecondBounce(double share, double shiftM, double spreadM, double leastM)
    implements MixtureChange {
  /** What is hardly nearer than the own echo cannot be told from it. */
  private static final double LEAST_NEARER_M = 0.03;

  /** Checks the figures; NaN is refused. */
  public SecondBounce {
    Checks.share("share", share);
    Checks.finite("shiftM", shiftM);
    Checks.notNegative("spreadM", spreadM);
    Checks.notNegative("leastM", leastM);
  }

  /** The reading before is as it was read; so is what is read now. */
  @Override
  public boolean beforeRange() {
    return false;
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
        double range = 2 * mixture.meanM(part) - before.meanM(other) - shiftM;
        if (range > leastM && range < mixture.meanM(part) - LEAST_NEARER_M) {
          double twice = Deviations.together(spreadM, 2 * mixture.deviationM(part));
          double deviation = Deviations.together(twice, before.deviationM(other));
          double more = share * before.share(other);
          mixture.add(range, deviation, more * mixture.share(part));
          moved += more;
        }
      }
      mixture.scaleShare(part, 1 - Math.min(1, moved));
    }
  }
}
