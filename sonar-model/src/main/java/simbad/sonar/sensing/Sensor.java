package simbad.sonar.sensing;

/**
 * The one small interface by which a belt takes any sensor model.
 *
 * <p>An implementation is bound to what it senses and to its source of chance when it is made; it
 * may remember earlier pings. It allocates nothing per ping where it can.
 */
@FunctionalInterface
public interface Sensor {
  /**
   * Pings with every transducer of the belt once.
   *
   * @param poses where the transducers are, world frame
   * @param timeS simulated time of the ping in seconds; never decreases between resets
   * @param readings receives the reading of each transducer, same indices; every entry is set
   */
  void ping(TransducerPoses poses, double timeS, Readings readings);

  /** Forgets earlier pings. A sensor without memory does nothing. */
  default void reset() {}
}
