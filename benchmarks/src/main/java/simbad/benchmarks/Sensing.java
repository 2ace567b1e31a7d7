package simbad.benchmarks;

import simbad.sim.RangeSensorBelt;

/** How often a robot reads its belt. */
public enum Sensing {
  /** It has none. */
  NONE,
  /** Three times a simulated second, the default of Simbad's factory: in every 7th step or so. */
  DEFAULT_RATE,
  /** In every step. */
  EVERY_STEP;

  void configure(RangeSensorBelt belt) {
    belt.setUpdateOnEachFrame(this == EVERY_STEP);
  }
}
