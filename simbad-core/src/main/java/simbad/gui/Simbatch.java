package simbad.gui;

import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/** Runs a simulation step by step, as fast as the caller asks, without a display. */
public class Simbatch {
  private final World world;
  private final Simulator simulator;

  /**
   * Creates the world and its agents.
   *
   * @param environment what the world contains
   * @param do3DRendering accepted for old programs; sensing does not need rendering
   */
  public Simbatch(EnvironmentDescription environment, boolean do3DRendering) {
    world = new World(environment);
    simulator = new Simulator(null, world, environment);
  }

  /** Puts every agent back to its start and prepares the behaviours; to be called first. */
  public void reset() {
    simulator.resetSimulation();
    simulator.initBehaviors();
  }

  /** Returns what steps the agents. */
  public Simulator getSimulator() {
    return simulator;
  }

  /** Returns the world. */
  public World getWorld() {
    return world;
  }

  /** Does one step. */
  public void step() {
    simulator.simulateOneStep();
  }

  /** Frees what the simulation holds. */
  public void dispose() {
    simulator.dispose();
    world.dispose();
  }
}
