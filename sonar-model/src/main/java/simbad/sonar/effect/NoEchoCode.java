package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * A number stands for "no echo": pings that hear nothing are reported as a range that no echo came
 * from, 0 or the sensor's end, always the same.
 *
 * @param codeM the number, metres, at least 0
 * @param share of the silent pings that read it, in [0, 1]; 0 is neutral
 * @param lostShare of the pings with an echo that are lost and count as silent, in [0, 1)
 */
public record NoEchoCode(double codeM, double share, double lostShare) implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public NoEchoCode {
    Checks.notNegative("codeM", codeM);
    Checks.share("share", share);
    Checks.share("lostShare", lostShare);
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
    mixture.scaleShares(1 - lostShare);
    double silent = Math.max(0, 1 - mixture.echoShare());
    mixture.add(codeM, 0, share * silent);
  }
}
