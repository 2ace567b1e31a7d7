package simbad.sonar.effect;

/**
 * A flat face that is not in the scene answers where the sensor looks at it squarely enough: by the
 * foot of the perpendicular from the sensor, as a mirror does, or by its nearest point.
 *
 * @param xM middle of the face, metres
 * @param zM middle of the face, metres
 * @param normalRad heading of the face's normal
 * @param halfWidthM half its width, metres; at least 0, 0 is a post
 * @param squareRad greatest angle between the sensor's heading and the normal's opposite
 * @param share of such pings that it answers, in [0, 1]; 0 is neutral
 */
public record UnmodelledObject(
    double xM, double zM, double normalRad, double halfWidthM, double squareRad, double share)
    implements ArrivalChange {
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
    // A face seen from behind answers as well: what is found is where it is, not which side it has.
    double before = dx * normalX + dz * normalZ;
    double along = dz * normalX - dx * normalZ;
    double foot = Math.max(-halfWidthM, Math.min(halfWidthM, along));
    double toX = -before * normalX - (along - foot) * -normalZ;
    double toZ = -before * normalZ - (along - foot) * normalX;
    double distance = Math.sqrt(toX * toX + toZ * toZ);
    double heading = geometry.headingRad(ping);
    double facing = (toX * Math.cos(heading) - toZ * Math.sin(heading)) / distance;
    if (facing >= Math.cos(geometry.coneHalfAngleRad()) && square(heading, before)) {
      arrivals.add(distance, 0, share);
    }
  }

  private boolean square(double heading, double before) {
    double against = -Math.cos(heading - normalRad) * Math.signum(before);
    return halfWidthM == 0 || against >= Math.cos(squareRad);
  }
}
