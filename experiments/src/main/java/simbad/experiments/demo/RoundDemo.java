package simbad.experiments.demo;

import simbad.obstacles.RoundObstacle;

/** A robot circles the round extrusion at the edge of its detection shadow. */
public final class RoundDemo extends EdgeDemo {
  /** Creates the environment. */
  public RoundDemo() {
    super(new RoundObstacle(middle(), 0));
  }
}
