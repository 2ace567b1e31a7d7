package simbad.benchmarks;

import java.util.ArrayList;
import java.util.List;
import simbad.gui.Simbatch;
import simbad.sim.EnvironmentDescription;

/** A Simbad world of obstacles on a grid, with robots that circle between them. */
final class Arena {
  /** Sonars on a belt, unless a benchmark says otherwise. */
  static final int SONARS = 12;

  /** Side of a box. */
  static final double BOX_M = 0.6;

  /** Steps in which every robot comes once round its circle. */
  static final int STEPS_ROUND = 252;

  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final List<CirclingRobot> robots = new ArrayList<>();
  private final Simbatch simulation;

  Arena(Belt belt, int obstacles, int robotCount, int sonars, Sensing sensing) {
    Grid grid = new Grid(obstacles, robotCount);
    for (int i = 0; i < obstacles; i++) {
      belt.place(environment, i, grid.post(i));
    }
    for (int i = 0; i < robotCount; i++) {
      robots.add(new CirclingRobot(grid.cell(i), belt, sonars, sensing));
    }
    robots.forEach(environment::add);
    simulation = new Simbatch(environment, false);
    simulation.reset();
    checkDriving(sensing);
  }

  /**
   * Drives every robot once round. A robot that is stopped or hears nothing is faster than one that
   * works: the figures would be worth nothing.
   */
  private void checkDriving(Sensing sensing) {
    boolean[] heard = new boolean[robots.size()];
    for (int step = 0; step < STEPS_ROUND; step++) {
      step();
      for (int i = 0; i < heard.length; i++) {
        heard[i] |= robots.get(i).hears();
        if (robots.get(i).collisionDetected()) {
          throw new IllegalStateException("robot " + i + " drives against something");
        }
      }
    }
    int hearing = 0;
    for (boolean one : heard) {
      hearing += one ? 1 : 0;
    }
    // Round a post, some stand where its shadow has an indentation and rightly hear nothing.
    if (sensing == Sensing.NONE ? hearing > 0 : 2 * hearing < heard.length) {
      throw new IllegalStateException(hearing + " of " + heard.length + " robots hear");
    }
  }

  void step() {
    simulation.step();
  }

  void dispose() {
    simulation.dispose();
  }
}
