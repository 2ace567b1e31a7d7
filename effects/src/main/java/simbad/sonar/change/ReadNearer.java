package simbad.sonar.change;

import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;

/**
 * Some echoes are read nearer than they are, each by an amount that the reading before tells: what
 * is left of the ping before comes first.
 */
interface ReadNearer extends MixtureChange {
  /** Returns the share of the echoes after an echo, in [0, 1]; 0 is neutral. */
  double share();

  /** Returns what is read instead of an own range after the reading before, metres. */
  double nearerM(double ownM, double beforeM);

  /** Tells whether it is read at all. */
  boolean isRead(double nearerM, double ownM);

  /**
   * Returns its standard deviation, of those of the own range and of the reading before, metres.
   */
  double nearerDeviationM(double ownM, double beforeM);

  @Override
  default void apply(Moment moment, Mixture mixture) {
    Mixture before = moment.before();
    if (share() == 0 || before.size() == 0) {
      return;
    }
    int parts = mixture.size();
    for (int part = 0; part < parts; part++) {
      double ownM = mixture.meanM(part);
      double moved = 0;
      for (int other = 0; other < before.size(); other++) {
        double range = nearerM(ownM, before.meanM(other));
        if (isRead(range, ownM)) {
          double more = share() * before.share(other);
          mixture.add(
              range,
              nearerDeviationM(mixture.deviationM(part), before.deviationM(other)),
              more * mixture.share(part));
          moved += more;
        }
      }
      mixture.scaleShare(part, 1 - Math.min(1, moved));
    }
  }
}
