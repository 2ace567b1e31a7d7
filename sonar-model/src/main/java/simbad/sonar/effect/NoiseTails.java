package simbad.sonar.effect;

/**
 * Some ranges scatter far more than the others do.
 *
 * @param share of the ranges that do, in [0, 1]; 0 is neutral
 * @param deviationM their standard deviation, metres
 */
public record NoiseTails(double share, double deviationM) implements MixtureChange {
  @Override
  public boolean beforeRange() {
    return false;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (share == 0) {
      return;
    }
    int parts = mixture.size();
    for (int part = 0; part < parts; part++) {
      if (mixture.halfWidthM(part) == 0) {
        double own = mixture.deviationM(part);
        mixture.add(
            mixture.meanM(part),
            Math.sqrt(own * own + deviationM * deviationM),
            share * mixture.share(part));
        mixture.scaleShare(part, 1 - share);
      }
    }
  }
}
