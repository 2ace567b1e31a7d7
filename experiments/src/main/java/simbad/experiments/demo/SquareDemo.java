package simbad.experiments.demo;

import simbad.obstacles.SquareObstacle;

/** A robot circles the square extrusion at the edge of its detection shadow. */
public final class SquareDemo extends EdgeDemo {
  /** Creates the environment. */
  public SquareDemo() {
    super(new SquareObstacle(middle(), 0));
  }
}
