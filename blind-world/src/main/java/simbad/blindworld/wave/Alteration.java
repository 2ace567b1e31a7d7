package simbad.blindworld.wave;

import java.util.List;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Track;

/** How a world differs from the one that was calibrated. Every method's default changes nothing. */
public interface Alteration {

  /** The sonar that stands under a label. */
  default Gear gear(String sensor, Gear gear) {
    return gear;
  }

  /** The air. */
  default Air air(Air air) {
    return air;
  }

  /** By how much the air scatters an echo's level from ping to ping, in decibels. */
  default double scatterDb(double scatterDb) {
    return scatterDb;
  }

  /** What sends echoes back, the scene's obstacles first and in its order. */
  default List<Reflector> reflectors(List<Reflector> reflectors) {
    return reflectors;
  }

  /** The true poses of a recording's rows. */
  default List<Pose> poses(Recording recording, List<Pose> poses) {
    return poses;
  }

  /** The most that {@link Ear#louderDb} ever returns, at least 0. */
  default double headroomDb() {
    return 0;
  }

  /**
   * What the alteration does to the pings of one track; asked for at the track's first ping.
   *
   * @param recording what is believed
   * @param track the run and transducer
   * @param repeatSeed the same for all tracks of one repeat, for chance that they share
   */
  default Ear ear(Recording recording, Track track, long repeatSeed) {
    return Ear.UNCHANGED;
  }
}
