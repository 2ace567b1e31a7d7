package simbad.sonar.change;

import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * Some echoes arrive by a way that is longer by a constant, others by one that is longer in
 * proportion.
 *
 * @param added ways that are longer by a constant
 * @param scaled ways that are longer in proportion
 */
public record MixedMultipath(Multipath added, Multipath scaled) implements MixtureChange {
  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    int parts = mixture.size();
    added.apply(moment, mixture);
    // What already took the long way is not sent on another one.
    if (scaled.share() > 0) {
      scaled.apply(moment, mixture, parts);
    }
  }
}
