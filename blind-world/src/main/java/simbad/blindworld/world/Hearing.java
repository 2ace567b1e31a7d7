package simbad.blindworld.world;

/**
 * What a change does to the pings of one track, in the order in which a ping goes through it. Every
 * method's default changes nothing. No echo is an infinite distance.
 */
public interface Hearing {

  /** The hearing of a change that leaves pings alone. */
  Hearing UNCHANGED = new Hearing() {};

  /** The threshold of one obstacle; 0 is never heard. */
  default double thresholdM(double thresholdM, Sight sight, Ping ping) {
    return thresholdM;
  }

  /** The distance of the arrival that is taken for the echo. */
  default double echoM(double distanceM, Ping ping) {
    return distanceM;
  }

  /** The range that a heard echo gives before noise and steps. */
  default double rangeM(double rangeM, Ping ping) {
    return rangeM;
  }

  /** The reading in steps. {@code rangeM} is the range with noise, before any step. */
  default double steppedM(double readingM, double rangeM, Ping ping) {
    return readingM;
  }

  /** The reading as it is reported; infinite is a no-echo. */
  default double reportedM(double readingM, Ping ping) {
    return readingM;
  }
}
