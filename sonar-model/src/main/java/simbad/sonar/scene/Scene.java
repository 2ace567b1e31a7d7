package simbad.sonar.scene;

import java.util.List;

/**
 * All that a sensor may hear.
 *
 * @param obstacles in any order; may be empty
 */
public record Scene(List<Obstacle> obstacles) {
  /** Copies the list. */
  public Scene {
    obstacles = List.copyOf(obstacles);
  }
}
