package simbad.experiments.demo;

import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;

/** A robot circles any obstacle at the edge of its detection shadow. */
public final class ObstacleDemo extends EdgeDemo {
  /**
   * Creates the environment.
   *
   * @param type of the obstacle
   */
  public ObstacleDemo(ObstacleType type) {
    super(new SonarObstacle(middle(), 0, type));
  }
}
