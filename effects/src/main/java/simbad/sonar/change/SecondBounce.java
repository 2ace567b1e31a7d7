package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;

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
    implements ReadNearer {
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
  public double nearerM(double ownM, double beforeM) {
    return 2 * ownM - beforeM - shiftM;
  }

  @Override
  public boolean isRead(double nearerM, double ownM) {
    return nearerM > leastM && nearerM < ownM - LEAST_NEARER_M;
  }

  @Override
  public double nearerDeviationM(double ownM, double beforeM) {
    return Deviations.together(Deviations.together(spreadM, 2 * ownM), beforeM);
  }
}
