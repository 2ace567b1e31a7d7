package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Another ranger with a period of its own is heard: the range that its sound seems to come from
 * walks by the same step from ping to ping, round and round. It is read where it comes before the
 * echo.
 *
 * @param share of the pings that hear it, in [0, 1]; 0 is neutral
 * @param lowM range that it starts again from, metres
 * @param bandM how far it walks before it starts again, metres
 * @param stepM by how much it walks, metres for each ping
 * @param startM range at the first ping of a transducer in a run, metres
 * @param spreadM standard deviation of the range, metres
 */
public record WalkingCrosstalk(
    double share, double lowM, double bandM, double stepM, double startM, double spreadM)
    implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public WalkingCrosstalk {
    Checks.share("share", share);
    Checks.notNegative("lowM", lowM);
    Checks.positive("bandM", bandM);
    Checks.finite("stepM", stepM);
    Checks.finite("startM", startM);
    Checks.notNegative("spreadM", spreadM);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    if (share == 0) {
      return;
    }
    double way = startM - lowM + stepM * moment.geometry().order(moment.ping());
    arrivals.add(lowM + way - bandM * Math.floor(way / bandM), spreadM, share);
  }
}
