package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * A flat face that is not in the scene answers where the sensor looks at it squarely enough.
 *
 * <p>It is heard when its nearest point lies in the cone and the sensor's heading is near enough to
 * the face's normal. A mirror answers only from where its nearest point is the foot of the
 * perpendicular. From behind, against its normal, the face is not heard.
 *
 * @param xM middle of the face, metres
 * @param zM middle of the face, metres
 * @param normalRad heading of the face's normal
 * @param halfWidthM half its width, metres
 * @param squareRad greatest angle between the heading and the normal's opposite; 0 is a mirror
 * @param reachM greatest distance that it is heard from, metres
 * @param share of such pings that it answers, in [0, 1]; 0 is neutral
 */
public record UnmodelledObject(
    double xM,
    double zM,
    double normalRad,
    double halfWidthM,
    double squareRad,
    double reachM,
    double share)
    implements ArrivalChange {
  /** Checks the figures; NaN is refused. */
  public UnmodelledObject {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.finite("normalRad", normalRad);
    Checks.notNegative("halfWidthM", halfWidthM);
    Checks.notNegative("squareRad", squareRad);
    Checks.notNegativeOrInfinite("reachM", reachM);
    Checks.share("share", share);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    if (share == 0) {
      return;
    }
    Geometry geometry = moment.geometry();
    int ping = moment.ping();
    double dx = geometry.xM(ping) - xM;
    double dz = geometry.zM(ping) - zM;
    double normalX = Math.cos(normalRad);
    double normalZ = -Math.sin(normalRad);
    double before = dx * normalX + dz * normalZ;
    double along = dz * normalX - dx * normalZ;
    double beside = along - Math.max(-halfWidthM, Math.min(halfWidthM, along));
    if (before <= 0 || (beside != 0 && squareRad == 0)) {
      return;
    }
    double toX = -before * normalX + beside * normalZ;
    double toZ = -before * normalZ - beside * normalX;
    double distance = Math.sqrt(toX * toX + toZ * toZ);
    double heading = geometry.headingRad(ping);
    double facing = (toX * Math.cos(heading) - toZ * Math.sin(heading)) / distance;
    boolean inCone = facing >= Math.cos(geometry.coneHalfAngleRad());
    if (inCone
        && distance <= Math.min(reachM, geometry.sensor().maxRangeM())
        && isSquare(heading)) {
      arrivals.add(distance, 0, share);
    }
  }

  private boolean isSquare(double heading) {
    double against = -Math.cos(heading - normalRad);
    return squareRad == 0 || against >= Math.cos(squareRad);
  }
}
