package simbad.blindworld.wave;

import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;

/**
 * One ping as it is being heard: what an alteration may look at.
 *
 * @param random chance
 * @param indexInTrack how many pings of this run and transducer came before
 * @param tS the time within the run, in seconds
 * @param share how much of the whole recording came before, in [0, 1)
 */
public record WavePing(RandomGenerator random, int indexInTrack, double tS, double share) {
  /** Refuses what is no such thing. */
  public WavePing {
    Checks.finite("time", tS);
    Checks.share("share", share);
  }
}
