package simbad.sonar.predict;

import java.util.random.RandomGenerator;
import simbad.sonar.ping.PoseTrack;
import simbad.sonar.ping.TruePose;

/** One transducer of a diagnosed sensor: where it really is, and what it remembers. */
final class Transducer {
  private final int index;
  private final PingModel pings;
  private final PoseTrack track;
  private final double startS;
  private final Recollection recollection;

  /**
   * Creates a transducer.
   *
   * @param index its place in the geometry of the pings
   * @param model what it reads
   * @param pings the model's pings, shared with other transducers
   * @param track where it really is
   * @param startS time of the first ping, seconds
   */
  Transducer(int index, ChangedModel model, PingModel pings, PoseTrack track, double startS) {
    this.index = index;
    this.pings = pings;
    this.track = track;
    this.startS = startS;
    recollection = new Recollection(model, pings);
  }

  /**
   * Sends a ping.
   *
   * @param timeS of the ping; never decreases
   * @param pose the believed one; moved to the true one
   * @param random source of chance
   * @return what is read in metres, the least distance to nothing for no echo: infinity
   */
  double ping(double timeS, TruePose pose, RandomGenerator random) {
    track.next(timeS, pose);
    pings.geometry().look(index, pose, timeS - startS);
    return recollection.read(index, timeS, random);
  }
}
