package simbad.sonar.change;

import simbad.sonar.check.Checks;

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
    implements ReadNearer {
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
  public double nearerM(double ownM, double beforeM) {
    return ownFactor * ownM + beforeFactor * beforeM - shiftM;
  }

  @Override
  public boolean isRead(double nearerM, double ownM) {
    return nearerM > LEAST_RANGE_M && nearerM < ownM;
  }

  @Override
  public double nearerDeviationM(double ownM, double beforeM) {
    double own = ownFactor * ownM;
    double former = beforeFactor * beforeM;
    return Math.sqrt(own * own + former * former + spreadM * spreadM);
  }
}
