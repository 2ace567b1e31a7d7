package simbad.obstacles;

import javax.vecmath.Vector3d;

/** The one inch round aluminium extrusion of Kranz (2014), with its detection shadow. */
public final class RoundObstacle extends SonarObstacle {
  /**
   * Places it.
   *
   * @param position middle of the bottom face, metres; copied
   * @param turnRad counter-clockwise as seen from above
   */
  public RoundObstacle(Vector3d position, double turnRad) {
    super(position, turnRad, Catalogue.find("round").orElseThrow());
  }
}
