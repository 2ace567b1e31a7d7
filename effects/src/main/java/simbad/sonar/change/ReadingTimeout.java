package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * A clock stops the listening: what would read more is lost. An echo whose mean range is near the
 * end is heard as often as its scatter leaves it below.
 *
 * @param mostM greatest reading, metres, above 0; infinity is neutral
 */
public record ReadingTimeout(double mostM) implements MixtureChange {
  /** Checks the figure; NaN is refused. */
  public ReadingTimeout {
    Checks.positiveOrInfinite("mostM", mostM);
  }

  @Override
  public boolean beforeRange() {
    return false;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (mostM == Double.POSITIVE_INFINITY) {
      return;
    }
    for (int part = 0; part < mixture.size(); part++) {
      mixture.scaleShare(part, mixture.below(part, mostM));
    }
  }
}
