package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.ArrivalChange;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.LevelEcho;
import simbad.sonar.ping.Moment;

/**
 * A round post that is not in the scene, under the level law: as strong from all sides.
 *
 * @param xM x of its axis, world frame, metres
 * @param zM z of its axis, world frame, metres
 * @param radiusM metres; 0 for a thin one
 * @param strengthDb target strength, decibels; negative infinity is neutral
 */
public record LevelPost(double xM, double zM, double radiusM, double strengthDb)
    implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public LevelPost {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.notNegative("radiusM", radiusM);
    Checks.number("strengthDb", strengthDb);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    double toX = xM - moment.geometry().xM(moment.ping());
    double toZ = zM - moment.geometry().zM(moment.ping());
    double share = 1 - radiusM / Math.sqrt(toX * toX + toZ * toZ);
    if (share > 0 && strengthDb > Double.NEGATIVE_INFINITY) {
      LevelEcho.add(moment, arrivals, share * toX, share * toZ, strengthDb);
    }
  }
}
