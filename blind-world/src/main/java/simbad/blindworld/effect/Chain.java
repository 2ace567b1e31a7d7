package simbad.blindworld.effect;

import simbad.blindworld.world.Ping;

/** A state that begins and ends by chance. */
final class Chain {

  private final double begins;
  private final double ends;
  private boolean on;
  private boolean begun;

  Chain(double begins, double ends) {
    this.begins = begins;
    this.ends = ends;
  }

  /** The state at the next ping; the first is drawn from how often the state is on at all. */
  boolean next(Ping ping) {
    double draw = ping.random().nextDouble();
    if (!begun) {
      begun = true;
      on = begins > 0 && draw < begins / (begins + ends);
    } else {
      on = on ? draw >= ends : draw < begins;
    }
    return on;
  }
}
