package simbad.gap.motion;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;
import simbad.motion.format.MotionRow;
import simbad.sonar.format.DataFormatException;

/** Leaves out what a tracker only repeated: there the robot was not seen. */
public final class StuckTrack {
  private StuckTrack() {}

  /**
   * Returns a drive without the rows that an audit found to be repeated.
   *
   * @param data the drive
   * @param folder that it was read from
   * @param audit what was found of it
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionData without(MotionData data, MotionFolder folder, List<AuditFinding> audit)
      throws DataFormatException {
    return repeated(audit).isEmpty() ? data : without(data, folder.trackRows(), audit);
  }

  private static Set<Integer> repeated(List<AuditFinding> audit) {
    return audit.stream()
        .filter(finding -> finding.check() == AuditCheck.TRACK_STILL)
        .flatMap(finding -> finding.rows().stream())
        .collect(Collectors.toUnmodifiableSet());
  }

  static MotionData without(
      MotionData data, Map<String, List<MotionRow<TrackPose>>> track, List<AuditFinding> audit) {
    Set<Integer> rows = repeated(audit);
    List<MotionRun> runs = data.runs().stream().map(run -> without(run, track, rows)).toList();
    return new MotionData(data.name(), data.robot(), runs, data.reference());
  }

  private static MotionRun without(
      MotionRun run, Map<String, List<MotionRow<TrackPose>>> track, Set<Integer> rows) {
    Set<TrackPose> out = new HashSet<>();
    for (MotionRow<TrackPose> row : track.getOrDefault(run.name(), List.of())) {
      if (rows.contains(row.row())) {
        out.add(row.value());
      }
    }
    List<TrackPose> kept = run.track().stream().filter(pose -> !out.contains(pose)).toList();
    return new MotionRun(run.name(), run.commands(), kept);
  }
}
