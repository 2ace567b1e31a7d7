package simbad.sonar.effect;

/**
 * Some echoes arrive by a longer way than the direct one.
 *
 * @param share of the echoes, in [0, 1]; 0 is neutral
 * @param factor what the range is multiplied by
 * @param extraM what is added then, metres
 * @param spreadM standard deviation of the way, metres
 */
public record Multipath(double share, double factor, double extraM, double spreadM)
    implements MixtureChange {
  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (share == 0) {
      return;
    }
    apply(mixture, mixture.size());
  }

  /** Sends some of the first parts alone the long way. */
  void apply(Mixture mixture, int parts) {
    for (int part = 0; part < parts; part++) {
      double own = factor * mixture.deviationM(part);
      mixture.add(
          mixture.meanM(part) * factor + extraM,
          Math.sqrt(own * own + spreadM * spreadM),
          share * mixture.share(part));
      mixture.scaleShare(part, 1 - share);
    }
  }
}
