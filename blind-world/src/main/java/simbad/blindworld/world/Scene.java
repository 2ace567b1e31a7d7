package simbad.blindworld.world;

import java.util.List;
import simbad.blindworld.check.Checks;

/**
 * What the simulator believes.
 *
 * @param noEchoM the range that a no-echo counts as
 * @param sensor the sonar
 * @param obstacles at least one
 */
public record Scene(double noEchoM, Sensor sensor, List<Obstacle> obstacles) {

  /** Copies the list. */
  public Scene {
    Checks.positive("no echo", noEchoM);
    obstacles = List.copyOf(obstacles);
  }
}
