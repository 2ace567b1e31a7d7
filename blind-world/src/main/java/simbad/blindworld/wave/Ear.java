package simbad.blindworld.wave;

/**
 * What an alteration does to the pings of one track, in the order in which a ping goes through it.
 * Every method's default changes nothing. No echo is an infinite time or range.
 */
public interface Ear {

  /** The ear of an alteration that leaves pings alone. */
  Ear UNCHANGED = new Ear() {};

  /** By how much the ping is louder, in decibels; never more than the alteration's headroom. */
  default double louderDb(WavePing ping) {
    return 0;
  }

  /** When the first echo is taken to have come, after the trigger, in seconds. */
  default double arrivalS(double arrivalS, WavePing ping) {
    return arrivalS;
  }

  /** The range before any step. */
  default double rangeM(double rangeM, WavePing ping) {
    return rangeM;
  }

  /** The reading in steps. {@code rangeM} is the range before any step. */
  default double steppedM(double readingM, double rangeM, WavePing ping) {
    return readingM;
  }

  /** The reading as it is reported; infinite is a no-echo. */
  default double reportedM(double readingM, WavePing ping) {
    return readingM;
  }
}
