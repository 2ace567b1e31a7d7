package simbad.blindworld.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Speeds and rates of turn of a recording's rows, by differences along each track. */
final class Motions {

  private Motions() {}

  static List<Ping.Motion> of(Recording recording) {
    List<Ping.Motion> motions =
        new ArrayList<>(Collections.nCopies(recording.size(), Ping.Motion.NONE));
    for (Track track : recording.tracks()) {
      List<Integer> rows = track.rows();
      for (int k = 0; k + 1 < rows.size(); k++) {
        Ping.Motion motion = between(recording, rows.get(k), rows.get(k + 1));
        motions.set(rows.get(k), motion);
        motions.set(rows.get(k + 1), motion);
      }
    }
    return motions;
  }

  private static Ping.Motion between(Recording recording, int from, int to) {
    double seconds = Math.max(1e-6, recording.tS(to) - recording.tS(from));
    Pose a = recording.pose(from);
    Pose b = recording.pose(to);
    double turn = Math.IEEEremainder(b.headingRad() - a.headingRad(), 2 * Math.PI);
    return new Ping.Motion(a.distanceM(b) / seconds, turn / seconds);
  }
}
