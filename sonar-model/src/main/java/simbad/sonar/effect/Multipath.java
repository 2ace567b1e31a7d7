package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Some echoes arrive by a longer way than the direct one; after the sensor's time is over they are
 * lost.
 *
 * @param share of the echoes, in [0, 1]; 0 is neutral
 * @param factor what the range is multiplied by
 * @param extraM what is added then, metres
 * @param spreadM standard deviation of the way, metres
 */
public record Multipath(double share, double factor, double extraM, double spreadM)
    implements MixtureChange {
  /** Checks the figures; NaN is refused. */
  public Multipath {
    Checks.share("share", share);
    Checks.notNegative("factor", factor);
    Checks.notNegative("extraM", extraM);
    Checks.notNegative("spreadM", spreadM);
  }

  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (share == 0) {
      return;
    }
    apply(moment, mixture, mixture.size());
  }

  /** Sends some of the first parts alone the long way. */
  void apply(Moment moment, Mixture mixture, int parts) {
    double most = moment.geometry().sensor().maxRangeM();
    for (int part = 0; part < parts; part++) {
      double own = factor * mixture.deviationM(part);
      mixture.addUpTo(
          most,
          mixture.meanM(part) * factor + extraM,
          Math.sqrt(own * own + spreadM * spreadM),
          share * mixture.share(part));
      mixture.scaleShare(part, 1 - share);
    }
  }
}
