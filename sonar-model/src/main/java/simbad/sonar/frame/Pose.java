package simbad.sonar.frame;

/**
 * Where something stands and what it faces.
 *
 * @param position the place
 * @param heading the direction
 */
public record Pose(Point position, Heading heading) {
  /**
   * Creates a pose from plain numbers.
   *
   * @param xM metres
   * @param zM metres
   * @param headingRad counter-clockwise from +x, radians
   */
  public static Pose of(double xM, double zM, double headingRad) {
    return new Pose(new Point(xM, zM), new Heading(headingRad));
  }

  /**
   * Returns how far to one side of the heading a point lies.
   *
   * @param point anywhere; at the pose's own position the angle is 0
   * @return radians, positive counter-clockwise, in (-pi, pi]
   */
  public double offAxisRad(Point point) {
    double dx = point.xM() - position.xM();
    double dz = point.zM() - position.zM();
    return dx == 0 && dz == 0 ? 0 : Angles.signed(Math.atan2(-dz, dx) - heading.radians());
  }
}
