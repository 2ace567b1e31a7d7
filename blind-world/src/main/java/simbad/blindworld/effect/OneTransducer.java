package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Track;

/** Changes of one transducer's pings, and of which transducer a reading comes from. */
final class OneTransducer {

  private OneTransducer() {}

  /** Whether the k-th ping of a track is concerned. */
  interface When {
    boolean at(int k, int trackSize);
  }

  static Change only(String sensor, Change change) {
    return new Change() {
      @Override
      public Hearing hearing(Recording recording, Track track, long repeatSeed) {
        return track.sensor().equals(sensor)
            ? change.hearing(recording, track, repeatSeed)
            : Hearing.UNCHANGED;
      }
    };
  }

  /** The poses with those of two transducers exchanged, ping by ping of each run. */
  static List<Pose> swapped(Recording recording, List<Pose> poses, List<String> pair, When when) {
    List<Pose> changed = new ArrayList<>(poses);
    for (Track first : recording.tracks()) {
      for (Track second : recording.tracks()) {
        boolean belong =
            first.run().equals(second.run())
                && first.sensor().equals(pair.get(0))
                && second.sensor().equals(pair.get(1));
        int size = belong ? Math.min(first.rows().size(), second.rows().size()) : 0;
        for (int k = 0; k < size; k++) {
          if (when.at(k, size)) {
            changed.set(first.rows().get(k), poses.get(second.rows().get(k)));
            changed.set(second.rows().get(k), poses.get(first.rows().get(k)));
          }
        }
      }
    }
    return changed;
  }
}
