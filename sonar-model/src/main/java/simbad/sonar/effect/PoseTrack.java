package simbad.sonar.effect;

import java.util.Comparator;
import java.util.List;

/** All changes of poses, one after the other. */
final class PoseTrack {
  private final PoseChange.Track[] tracks;

  /** Starts to follow one sensor through one run. */
  PoseTrack(List<? extends Change> changes, String sensor, double runStartS) {
    tracks =
        changes.stream()
            .filter(PoseChange.class::isInstance)
            .map(PoseChange.class::cast)
            .sorted(Comparator.comparingInt(PoseChange::order))
            .map(change -> change.start(sensor, runStartS))
            .toArray(PoseChange.Track[]::new);
  }

  void next(double timeS, TruePose pose) {
    for (PoseChange.Track track : tracks) {
      track.next(timeS, pose);
    }
  }
}
