package simbad.sonar.ping;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import simbad.sonar.check.Checks;

/** All changes of poses, one after the other. */
public final class PoseTrack {
  private final PoseChange.Track[] tracks;

  /**
   * Starts to follow one sensor through one run.
   *
   * @param changes of which those of poses count
   * @param sensor label of the sensor
   * @param runStartS time of the run's first ping, seconds; NaN is refused
   */
  public PoseTrack(List<? extends Change> changes, String sensor, double runStartS) {
    Checks.number("runStartS", runStartS);
    List<PoseChange> moves = Change.only(PoseChange.class, changes);
    tracks = new PoseChange.Track[moves.size()];
    if (tracks.length > 0) {
      moves.sort(Comparator.comparingInt(PoseChange::order));
      Arrays.setAll(tracks, i -> moves.get(i).start(sensor, runStartS));
    }
  }

  /**
   * Moves the pose of the next ping.
   *
   * @param timeS of the ping, seconds; never decreases
   * @param pose the believed pose, which becomes the true one
   */
  public void next(double timeS, TruePose pose) {
    for (PoseChange.Track track : tracks) {
      track.next(timeS, pose);
    }
  }
}
