package simbad.gap.design;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * Poses to ping from, one after the other at an even pace.
 *
 * @param poses in the order to drive them
 * @param stepS seconds from one to the next
 */
record Manoeuvre(List<Pose> poses, double stepS) {
  /** Copies the poses. */
  Manoeuvre {
    poses = List.copyOf(poses);
  }

  /** Returns rows without readings. */
  List<ReadingRow> rows(String run, String sensor) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < poses.size(); i++) {
      rows.add(new ReadingRow(run, sensor, time(i), poses.get(i), NoEcho.NO_ECHO));
    }
    return rows;
  }

  /** In whole milliseconds, as files write it. */
  private double time(int index) {
    return Math.rint(index * stepS * 1e3) / 1e3;
  }
}
