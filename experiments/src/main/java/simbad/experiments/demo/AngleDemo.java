package simbad.experiments.demo;

import simbad.obstacles.AngleObstacle;

/** A robot circles the angle extrusion at the edge of its detection shadow. */
public final class AngleDemo extends EdgeDemo {
  /** Creates the environment. */
  public AngleDemo() {
    super(new AngleObstacle(middle(), 0));
  }
}
