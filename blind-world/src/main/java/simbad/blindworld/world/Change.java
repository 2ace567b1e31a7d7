package simbad.blindworld.world;

import java.util.List;
import java.util.random.RandomGenerator;

/** How a world differs from what is believed of it. Every method's default changes nothing. */
public interface Change {

  /**
   * The true poses of a recording's rows.
   *
   * @param recording what is believed
   * @param poses the poses so far, in the order of the rows; not to be changed in place
   * @param random chance, for changes that are {@link #restless}
   */
  default List<Pose> poses(Recording recording, List<Pose> poses, RandomGenerator random) {
    return poses;
  }

  /** True when the poses differ from one repeat to the next. */
  default boolean restless() {
    return false;
  }

  /** The obstacles as they really stand. */
  default List<Body> bodies(List<Body> bodies) {
    return bodies;
  }

  /** The beam of a transducer. */
  default Beam beam(String sensor, Beam beam) {
    return beam;
  }

  /**
   * What the change does to the pings of one track; asked for at the track's first ping.
   *
   * @param recording what is believed
   * @param track the run and transducer
   * @param repeatSeed the same for all tracks of one repeat, for chance that they share
   */
  default Hearing hearing(Recording recording, Track track, long repeatSeed) {
    return Hearing.UNCHANGED;
  }
}
