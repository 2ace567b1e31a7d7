package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * A reading is off by a whole period of the carrier: the echo crossed the threshold one wave later.
 *
 * @param share of the readings that are, in [0, 1]; 0 is neutral
 * @param stepM half a wavelength, metres: 4.3 mm at 40 kHz
 */
public record WaveHop(double share, double stepM) implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public WaveHop {
    Checks.share("share", share);
    Checks.notNegative("stepM", stepM);
  }

  @Override
  public boolean beforeRange() {
    return false;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    mixture.moveShare(share, stepM, 0);
  }
}
