package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * Where a transducer stands and looks.
 *
 * @param xM to the right, in metres
 * @param zM down the page, in metres
 * @param headingRad counter-clockwise as seen from above, 0 along +x; it looks along (cos, -sin)
 */
public record Pose(double xM, double zM, double headingRad) {
  /** Refuses what is no such thing. */
  public Pose {
    Checks.finite("x", xM);
    Checks.finite("z", zM);
    Checks.finite("heading", headingRad);
  }

  /** The pose turned on the spot, counter-clockwise, by so many radians. */
  public Pose turned(double byRad) {
    return new Pose(xM, zM, headingRad + byRad);
  }

  /** The pose at another place with the same heading. */
  public Pose at(double otherXM, double otherZM) {
    return new Pose(otherXM, otherZM, headingRad);
  }

  /** The distance to another pose's place, in metres. */
  public double distanceM(Pose other) {
    return StrictMath.hypot(other.xM - xM, other.zM - zM);
  }

  /** The pose a share of the way to another one, along the straight line and the shorter turn. */
  public Pose towards(Pose other, double share) {
    double turn = Math.IEEEremainder(other.headingRad - headingRad, 2 * Math.PI);
    return new Pose(
        xM + share * (other.xM - xM), zM + share * (other.zM - zM), headingRad + share * turn);
  }
}
