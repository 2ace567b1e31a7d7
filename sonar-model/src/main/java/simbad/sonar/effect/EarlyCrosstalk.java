package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Foreign sound arrives at any time and is read when it comes before the echo.
 *
 * @param share of the pings that have it, in [0, 1]; 0 is neutral
 * @param lowM least range, metres
 * @param highM greatest range, metres, above lowM
 */
public record EarlyCrosstalk(double share, double lowM, double highM) implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public EarlyCrosstalk {
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
    double silent = Math.max(0, 1 - mixture.echoShare());
    int parts = mixture.size();
    for (int part = 0; part < parts; part++) {
      double mean = Math.min(highM, Math.max(lowM, mixture.meanM(part)));
      double earlier = share * (mean - lowM) / (highM - lowM);
      if (earlier > 0) {
        mixture.addEven(lowM, mean, earlier * mixture.share(part));
        mixture.scaleShare(part, 1 - earlier);
      }
    }
    mixture.addEven(lowM, highM, share * silent);
  }
}
