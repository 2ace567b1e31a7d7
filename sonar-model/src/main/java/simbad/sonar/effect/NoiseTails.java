package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Some ranges scatter far more than the others do.
 *
 * @param share of the ranges that do, in [0, 1]; 0 is neutral
 * @param deviationM their standard deviation, metres
 */
public record NoiseTails(double share, double deviationM) implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public NoiseTails {
    Checks.share("share", share);
    Checks.notNegative("deviationM", deviationM);
  }

  @Override
  public boolean beforeRange() {
    return false;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    mixture.moveShare(share, 0, deviationM);
  }
}
