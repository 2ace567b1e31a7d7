package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;
import simbad.sonar.ping.PoseChange;

/**
 * A reading belongs to an earlier pose, and by how much earlier differs from ping to ping: a range
 * scatters by as much as it changes within the time that is uncertain. To first order, from the
 * obstacle's nearest points in the cone at a ping and at its transducer's ping before; where one of
 * them has none, it does not scatter.
 *
 * @param delay seconds or pings on average
 * @param scatterPings standard deviation of the delay, in periods of the transducer, at least 0
 */
public record ScatteredLatency(PoseChange delay, double scatterPings)
    implements PoseChange, MixtureChange {
  /** Checks the figure; NaN is refused. */
  public ScatteredLatency {
    Checks.notNegative("scatterPings", scatterPings);
  }

  @Override
  public int order() {
    return delay.order();
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return delay.start(sensor, runStartS);
  }

  @Override
  public boolean looksBack() {
    return true;
  }

  @Override
  public boolean beforeRange() {
    return true;
  }

  @Override
  public void apply(Moment moment, Mixture mixture) {
    if (scatterPings == 0) {
      return;
    }
    Geometry geometry = moment.geometry();
    int end = (moment.ping() + 1) * geometry.obstacles();
    for (int line = moment.ping() * geometry.obstacles(); line < end; line++) {
      double wayM = Math.abs(geometry.nearestM(line) - geometry.nearestBeforeM(line));
      if (wayM < Double.POSITIVE_INFINITY) {
        scatter(geometry.nearestM(line), scatterPings * wayM, mixture);
      }
    }
  }

  private static void scatter(double rangeM, double byM, Mixture mixture) {
    for (int part = 0; part < mixture.size(); part++) {
      if (mixture.meanM(part) == rangeM) {
        mixture.move(part, rangeM, Deviations.together(mixture.deviationM(part), byM));
      }
    }
  }
}
