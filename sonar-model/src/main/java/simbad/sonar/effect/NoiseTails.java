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
    mixture.moveShare(share, 0, deviationM);
  }
}
