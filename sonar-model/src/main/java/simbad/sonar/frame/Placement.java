package simbad.sonar.frame;

import simbad.sonar.check.Checks;

/**
 * How an obstacle's own frame lies in the world: turned about +y, then moved.
 *
 * <p>Own (x, z) goes to (x cos a + z sin a, -x sin a + z cos a) + (xM, zM) with a = turnRad.
 *
 * @param xM where the obstacle's centre is, metres, finite
 * @param zM where the obstacle's centre is, metres, finite
 * @param turnRad the turn, counter-clockwise as seen from above, radians, finite
 */
public record Placement(double xM, double zM, double turnRad) {
  /** The own frame is the world's. */
  public static final Placement IDENTITY = new Placement(0, 0, 0);

  /** Checks that all are finite. */
  public Placement {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.finite("turnRad", turnRad);
  }

  /** Returns the same place turned further by an angle in radians. */
  public Placement turned(double byRad) {
    return new Placement(xM, zM, turnRad + byRad);
  }

  /** Returns the same turn at a place that is moved by metres. */
  public Placement moved(double byXM, double byZM) {
    return new Placement(xM + byXM, zM + byZM, turnRad);
  }

  /** Returns the world's point of a point of the own frame. */
  public Point worldFromObstacle(Point own) {
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    return new Point(xM + own.xM() * cos + own.zM() * sin, zM - own.xM() * sin + own.zM() * cos);
  }

  /** Returns the own frame's point of a point of the world; undoes {@link #worldFromObstacle}. */
  public Point obstacleFromWorld(Point world) {
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    double dx = world.xM() - xM;
    double dz = world.zM() - zM;
    return new Point(dx * cos - dz * sin, dx * sin + dz * cos);
  }

  /**
   * Returns the bearing of a place as seen from the obstacle.
   *
   * @param worldXM metres
   * @param worldZM metres
   * @return radians in [0, 2 pi); 0 - turn, normalised, at the centre itself
   */
  public double bearingRad(double worldXM, double worldZM) {
    return Angles.positive(Math.atan2(worldXM - xM, worldZM - zM) - turnRad);
  }

  /** Returns the distance of a place from the obstacle's centre in metres. */
  public double centreDistanceM(double worldXM, double worldZM) {
    double dx = worldXM - xM;
    double dz = worldZM - zM;
    return Math.sqrt(dx * dx + dz * dz);
  }
}
