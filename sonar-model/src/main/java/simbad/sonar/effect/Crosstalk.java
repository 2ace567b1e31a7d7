package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Now and then a range is read that has nothing to do with the scene, evenly spread.
 *
 * @param share of the pings, in [0, 1]; 0 is neutral
 * @param lowM least range, metres
 * @param highM greatest range, metres, above lowM
 * @param onlySilent whether only pings without an echo show it
 */
public record Crosstalk(double share, double lowM, double highM, boolean onlySilent)
    implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public Crosstalk {
    Checks.share("share", share);
    Checks.notNegative("lowM", lowM);
    Checks.above("highM", highM, lowM);
  }

  @Override
  public boolean beforeRange() {
    return false;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (share == 0) {
      return;
    }
    double free = onlySilent ? Math.max(0, 1 - mixture.echoShare()) : 1;
    if (!onlySilent) {
      mixture.scaleShares(1 - share);
    }
    mixture.addEven(lowM, highM, share * free);
  }
}
