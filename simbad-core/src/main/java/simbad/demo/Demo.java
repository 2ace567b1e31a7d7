package simbad.demo;

import simbad.sim.EnvironmentDescription;

/** An environment that shows something. Programs extend it, too. */
public class Demo extends EnvironmentDescription {
  /** Creates an empty environment. */
  public Demo() {}
}
