package simbad.obstacles;

import javax.vecmath.Vector3d;

/** The one inch square aluminium extrusion of Kranz (2014), with its detection shadow. */
public final class SquareObstacle extends SonarObstacle {
  /**
   * Places it.
   *
   * @param position middle of the bottom face, metres; copied
   * @param turnRad counter-clockwise as seen from above
   */
  public SquareObstacle(Vector3d position, double turnRad) {
    super(position, turnRad, Catalogue.find("square").orElseThrow());
  }
}
