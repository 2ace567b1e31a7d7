package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionFolder;
import simbad.motion.format.MotionRow;
import simbad.sonar.format.DataFormatException;

/** Whether commands and track can be what they are said to be, before anything is fitted. */
public final class MotionAudit {
  /** Rows that stand within this time of each other are the same. */
  private static final double SAME_S = 1e-9;

  /** No track goes on for days after the last command. */
  private static final double LONGEST_S = 1e5;

  private static final double HOLE_S = 0.25;
  private static final double MOST_HOLES = 0.5;
  private static final int LISTED = 1000;

  private final Map<String, List<MotionRow<Command>>> commands;
  private final Map<String, List<MotionRow<TrackPose>>> track;
  private final List<AuditFinding> findings = new ArrayList<>();

  private MotionAudit(
      Map<String, List<MotionRow<Command>>> commands,
      Map<String, List<MotionRow<TrackPose>>> track) {
    this.commands = commands;
    this.track = track;
  }

  /**
   * Audits a folder.
   *
   * @param folder with the files
   * @return what was found, worst first
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static List<AuditFinding> of(MotionFolder folder) throws DataFormatException {
    return of(folder.commandRows(), folder.trackRows(), !folder.robot().separateClocks());
  }

  static List<AuditFinding> of(
      Map<String, List<MotionRow<Command>>> commands,
      Map<String, List<MotionRow<TrackPose>>> track,
      boolean isOneClock) {
    MotionAudit audit = new MotionAudit(commands, track);
    audit.order();
    audit.overlap();
    audit.holes();
    audit.findings.addAll(new TrackCheck(commands, track).findings());
    // Where a unit is wrong, single commands are no slips.
    boolean refused = Audit.refuses(audit.findings);
    CommandCheck.of(commands).stream()
        .filter(found -> found.refuses() || !refused)
        .forEach(audit.findings::add);
    if (!Audit.refuses(audit.findings)) {
      audit.findings.addAll(LagCheck.of(commands, track, isOneClock));
    }
    // What is wrong with clocks or units looks like another drive, too.
    if (!Audit.refuses(audit.findings)) {
      audit.findings.addAll(FollowCheck.of(commands, track));
    }
    audit.findings.sort(Comparator.comparing(AuditFinding::severity).reversed());
    return List.copyOf(audit.findings);
  }

  private void order() {
    List<Integer> back = new ArrayList<>();
    List<Integer> twice = new ArrayList<>();
    for (List<MotionRow<TrackPose>> run : track.values()) {
      List<MotionRow<TrackPose>> sorted = sorted(run);
      for (int i = 1; i < run.size(); i++) {
        if (run.get(i).value().timeS() < run.get(i - 1).value().timeS() - SAME_S) {
          back.add(run.get(i).row());
        }
        TrackPose before = sorted.get(i - 1).value();
        TrackPose pose = sorted.get(i).value();
        if (pose.timeS() - before.timeS() < SAME_S && !pose.equals(before)) {
          twice.add(sorted.get(i).row());
        }
      }
    }
    if (!back.isEmpty()) {
      add(
          AuditCheck.TRACK_CLOCK,
          counted(back.size(), "row has", "rows have") + " an earlier time than the row before",
          back,
          "rows are read in order of time; if a clock was set back, give the rows after "
              + "it another run name",
          Severity.NOTE);
    }
    if (!twice.isEmpty()) {
      add(
          AuditCheck.TRACK_CLOCK,
          counted(twice.size(), "row has", "rows have")
              + " the time of another row and another pose",
          twice,
          "give two recordings two names in column run, or drop one row of each pair",
          Severity.WARN);
    }
  }

  static List<MotionRow<TrackPose>> sorted(List<MotionRow<TrackPose>> run) {
    return run.stream()
        .sorted(Comparator.comparingDouble((MotionRow<TrackPose> row) -> row.value().timeS()))
        .toList();
  }

  private void overlap() {
    for (Map.Entry<String, List<MotionRow<TrackPose>>> run : track.entrySet()) {
      double first = Double.POSITIVE_INFINITY;
      double last = Double.NEGATIVE_INFINITY;
      for (MotionRow<Command> row : commands.getOrDefault(run.getKey(), List.of())) {
        first = Math.min(first, row.value().timeS());
        last = Math.max(last, row.value().timeS());
      }
      List<MotionRow<TrackPose>> rows = sorted(run.getValue());
      double begins = rows.get(0).value().timeS();
      double ends = rows.get(rows.size() - 1).value().timeS();
      double times = (ends - begins) / (last - first);
      boolean apart =
          ends < first
              || ends - last > LONGEST_S
              || (begins > last && begins - last > ends - begins);
      if (apart || TrackCheck.near(times, 1000) || TrackCheck.near(times, 0.001)) {
        add(
            AuditCheck.TRACK_CLOCK,
            String.format(
                Locale.ROOT,
                "the track of run '%s' goes from %.3f to %.3f s, its commands from %.3f to "
                    + "%.3f s",
                run.getKey(),
                begins,
                ends,
                first,
                last),
            List.of(rows.get(0).row()),
            "write both times in seconds of one clock",
            Severity.REFUSE);
      }
    }
  }

  private void holes() {
    List<Integer> rows = new ArrayList<>();
    double missing = 0;
    double whole = 0;
    for (List<MotionRow<TrackPose>> run : track.values()) {
      List<MotionRow<TrackPose>> sorted = sorted(run);
      for (int i = 1; i < sorted.size(); i++) {
        double gap = sorted.get(i).value().timeS() - sorted.get(i - 1).value().timeS();
        whole += gap;
        if (gap > HOLE_S) {
          missing += gap;
          rows.add(sorted.get(i).row());
        }
      }
    }
    if (!rows.isEmpty()) {
      boolean much = missing > MOST_HOLES * whole;
      add(
          AuditCheck.TRACK_HOLES,
          String.format(
              Locale.ROOT,
              "%s of over %s s, %.1f s of %.1f s in all",
              counted(rows.size(), "hole", "holes"),
              HOLE_S,
              missing,
              whole),
          rows,
          much ? "track the robot at least four times a second" : "",
          much ? Severity.WARN : Severity.NOTE);
    }
  }

  private static String counted(int count, String one, String many) {
    return count + " " + (count == 1 ? one : many);
  }

  private void add(
      AuditCheck check, String what, List<Integer> rows, String suggestion, Severity severity) {
    findings.add(
        new AuditFinding(
            check,
            AuditFinding.File.TRACK,
            what,
            rows.stream().limit(LISTED).toList(),
            suggestion,
            "",
            severity));
  }
}
