package simbad.sonar.change;

import java.util.Arrays;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * A reading is made of the one before, as that was read: its echo's multiple, or what is left of
 * one that comes a period later.
 *
 * @param share of the pings after an echo, in [0, 1]; 0 is neutral
 * @param factor what the reading before is multiplied by
 * @param shiftM what is taken from it then, metres
 * @param spreadM standard deviation of that, metres
 * @param onlyNearer whether it is read only where it comes before the ping's own echo
 */
public record GhostReading(
    double share, double factor, double shiftM, double spreadM, boolean onlyNearer)
    implements MixtureChange {
  private static final double LEAST_RANGE_M = 0.02;
  private static final double AGAIN_M = 0.05;
  private static final double AGAIN_FACTOR = 0.5;

  /** Checks the figures; NaN is refused. */
  public GhostReading {
    Checks.share("share", share);
    Checks.finite("factor", factor);
    Checks.finite("shiftM", shiftM);
    Checks.notNegative("spreadM", spreadM);
  }

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
    double silent = Math.max(0, 1 - mixture.echoShare());
    double[] left = new double[parts];
    Arrays.fill(left, 1);
    for (int other = 0; other < before.size(); other++) {
      double range = factor * before.meanM(other) - shiftM;
      if (range > LEAST_RANGE_M && !isAgain(range, before.meanM(other))) {
        double chance = share * before.share(other);
        double taken = silent;
        for (int part = 0; part < parts; part++) {
          if (!onlyNearer || range < mixture.meanM(part)) {
            taken += mixture.share(part);
            left[part] -= chance;
          }
        }
        double deviation = Deviations.together(spreadM, factor * before.deviationM(other));
        mixture.add(range, deviation, chance * taken);
      }
    }
    for (int part = 0; part < parts; part++) {
      mixture.scaleShare(part, Math.max(0, left[part]));
    }
  }

  /** What comes again as it was is no ghost: readings resemble those before them for any reason. */
  private boolean isAgain(double rangeM, double beforeM) {
    return Math.abs(factor - 1) < AGAIN_FACTOR && Math.abs(rangeM - beforeM) < AGAIN_M;
  }
}
