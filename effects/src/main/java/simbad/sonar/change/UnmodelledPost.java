package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.ArrivalChange;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Moment;

/**
 * A round post that is not in the scene answers where the sensor looks at it squarely enough.
 *
 * @param xM its axis, metres
 * @param zM its axis, metres
 * @param radiusM metres; 0 for a thin one
 * @param reachM greatest distance of its surface that is heard, metres
 * @param squareRad greatest angle between the heading and its axis; at the cone's half angle or
 *     beyond, its edge is heard from as far off as the cone reaches
 * @param share of such pings that it answers, in [0, 1]; 0 is neutral
 */
public record UnmodelledPost(
    double xM, double zM, double radiusM, double reachM, double squareRad, double share)
    implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public UnmodelledPost {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.notNegative("radiusM", radiusM);
    Checks.notNegativeOrInfinite("reachM", reachM);
    Checks.notNegative("squareRad", squareRad);
    Checks.share("share", share);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    if (share == 0) {
      return;
    }
    Geometry geometry = moment.geometry();
    int ping = moment.ping();
    double toX = xM - geometry.xM(ping);
    double toZ = zM - geometry.zM(ping);
    double distance = Math.sqrt(toX * toX + toZ * toZ);
    double surface = distance - radiusM;
    double farthest = Math.min(reachM, geometry.sensor().maxRangeM());
    if (surface <= 0 || surface > farthest) {
      return;
    }
    double heading = geometry.headingRad(ping);
    double facing = (toX * Math.cos(heading) - toZ * Math.sin(heading)) / distance;
    double half = geometry.coneHalfAngleRad();
    if (facing >= Math.cos(Math.min(half, squareRad))) {
      arrivals.add(surface, 0, share);
    } else if (squareRad >= half) {
      beside(Math.acos(Math.max(-1, facing)) - half, distance, farthest, arrivals);
    }
  }

  /** Its axis is out of the cone: the cone's border may still meet it. */
  private void beside(double offRad, double distance, double farthest, Arrivals arrivals) {
    double aside = distance * Math.sin(offRad);
    if (offRad < Math.PI / 2 && aside <= radiusM) {
      double range = distance * Math.cos(offRad) - Math.sqrt(radiusM * radiusM - aside * aside);
      if (range <= farthest) {
        arrivals.add(range, 0, share);
      }
    }
  }
}
