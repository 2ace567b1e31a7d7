package simbad.benchmarks;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.gui.Simbatch;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sonar.frame.Point;

/** A Simbad world of boxes on a grid, with robots that circle between them. */
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

  Arena(int boxes, int robotCount, int sonars, Sensing sensing) {
    Grid grid = new Grid(boxes);
    for (int i = 0; i < boxes; i++) {
      environment.add(box(grid.post(i)));
    }
    for (int i = 0; i < robotCount; i++) {
      robots.add(new CirclingRobot(grid.cell(i, robotCount), sonars, sensing));
    }
    robots.forEach(environment::add);
    simulation = new Simbatch(environment, false);
    simulation.reset();
    checkDriving(sensing);
  }

  private Box box(Point at) {
    float side = (float) BOX_M;
    return new Box(new Vector3d(at.xM(), 0, at.zM()), new Vector3f(side, side, side), environment);
  }

  /**
   * Drives every robot once round. A robot that stands at a box or hears nothing is faster than one
   * that works: the figures would be worth nothing.
   */
  private void checkDriving(Sensing sensing) {
    boolean[] heard = new boolean[robots.size()];
    for (int step = 0; step < STEPS_ROUND; step++) {
      step();
      for (int i = 0; i < heard.length; i++) {
        heard[i] |= robots.get(i).hears();
        if (robots.get(i).collisionDetected()) {
          throw new IllegalStateException("robot " + i + " drives against a box");
        }
      }
    }
    for (int i = 0; i < heard.length; i++) {
      if (heard[i] != (sensing != Sensing.NONE)) {
        throw new IllegalStateException("robot " + i + (heard[i] ? " hears" : " hears nothing"));
      }
    }
  }

  void step() {
    simulation.step();
  }

  void dispose() {
    simulation.dispose();
  }
}
