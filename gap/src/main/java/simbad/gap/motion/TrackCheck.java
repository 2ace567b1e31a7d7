package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/**
 * Units, frame and continuity of a track, from how it goes with what was commanded. Pairs of poses
 * half a second apart are looked at: the way between them, the turn, and the direction of the way
 * beside the heading.
 */
final class TrackCheck {
  private static final double PAIR_S = 0.5;
  private static final int LEAST_PAIRS = 20;

  /** Less way has no direction. */
  private static final double MOVES_M_S = 0.02;

  private static final double TURNS_RAD_S = 0.1;

  /** Directions that agree by this much are one. */
  private static final double AGREES = 0.8;

  private static final double APART = 0.3;

  /** A factor is one of these if it is no further off. */
  private static final double NEAR = 1.6;

  /** A heading in radians that is taken for degrees turns 57 times too little. */
  private static final double BENDS_AS_IT_TURNS = 8;

  private static final double TURNED_RAD = Math.toRadians(30);
  private static final double JUMP_TIMES = 8;
  private static final double STILL_S = 3;

  private final Map<String, List<MotionRow<Command>>> commands;
  private final Map<String, List<MotionRow<TrackPose>>> track;
  private final List<Pair> pairs = new ArrayList<>();
  private final List<AuditFinding> findings = new ArrayList<>();

  /** Two poses, and what was commanded throughout. */
  private record Pair(int row, TrackPose from, TrackPose to, Command command) {
    double seconds() {
      return to.timeS() - from.timeS();
    }

    double wayM() {
      return Math.hypot(to.xM() - from.xM(), to.yM() - from.yM());
    }

    double turnRad() {
      return Math.IEEEremainder(to.headingRad() - from.headingRad(), 2 * Math.PI);
    }

    double course() {
      return Math.atan2(to.yM() - from.yM(), to.xM() - from.xM());
    }

    double heading() {
      return from.headingRad() + turnRad() / 2;
    }
  }

  TrackCheck(
      Map<String, List<MotionRow<Command>>> commands,
      Map<String, List<MotionRow<TrackPose>>> track) {
    this.commands = commands;
    this.track = track;
    track.forEach((run, rows) -> pair(run, MotionAudit.sorted(rows)));
  }

  private void pair(String run, List<MotionRow<TrackPose>> rows) {
    double longest = 2 * Math.max(PAIR_S, step(rows));
    List<Command> told = told(run);
    int at = 0;
    int from = 0;
    for (int to = 1; to < rows.size(); to++) {
      TrackPose a = rows.get(from).value();
      TrackPose b = rows.get(to).value();
      if (b.timeS() - a.timeS() < PAIR_S) {
        continue;
      }
      while (at + 1 < told.size() && told.get(at + 1).timeS() <= a.timeS()) {
        at++;
      }
      int end = at;
      while (end + 1 < told.size() && told.get(end + 1).timeS() <= b.timeS()) {
        end++;
      }
      boolean held = !told.isEmpty() && told.get(end).asksTheSameAs(told.get(at));
      if (held && b.timeS() - a.timeS() < longest) {
        pairs.add(new Pair(rows.get(from).row(), a, b, told.get(at)));
      }
      from = to;
    }
  }

  /** The usual time from one pose to the next: with a wrong unit it may be long. */
  private static double step(List<MotionRow<TrackPose>> rows) {
    double[] steps = new double[rows.size() - 1];
    for (int i = 0; i < steps.length; i++) {
      steps[i] = rows.get(i + 1).value().timeS() - rows.get(i).value().timeS();
    }
    return steps.length == 0 ? 0 : median(steps);
  }

  List<AuditFinding> findings() {
    units();
    headings();
    turnUnit();
    frame();
    // In a wrong unit every step is far.
    if (findings.stream().noneMatch(found -> found.check() == AuditCheck.TRACK_UNIT)) {
      track.values().forEach(rows -> jumps(MotionAudit.sorted(rows)));
    }
    still();
    return findings;
  }

  /** The way that was seen over the one that was commanded. */
  private void units() {
    double[] factors =
        pairs.stream()
            .filter(p -> Math.abs(p.command().speedMPerS()) > MOVES_M_S)
            .mapToDouble(p -> p.wayM() / p.seconds() / Math.abs(p.command().speedMPerS()))
            .toArray();
    if (factors.length < LEAST_PAIRS) {
      return;
    }
    double factor = median(factors);
    String wrong = "";
    String suggestion = "";
    if (near(factor, 1000)) {
      wrong = "positions look like millimetres";
      suggestion = "divide x_m and z_m by 1000";
    } else if (near(factor, 100)) {
      wrong = "positions look like centimetres";
      suggestion = "divide x_m and z_m by 100";
    } else if (near(factor, 0.001)) {
      wrong = "times look like milliseconds, or positions like kilometres";
      suggestion = "divide t_s by 1000, or multiply x_m and z_m by 1000";
    } else if (factor > 20 || factor < 0.01) {
      wrong = "no robot moves like this";
      suggestion = "check the units, and that commands and track belong to one drive";
    }
    if (!wrong.isEmpty()) {
      String what =
          String.format(Locale.ROOT, "the way is %.3g times what was commanded: %s", factor, wrong);
      add(AuditCheck.TRACK_UNIT, what, List.of(firstMoving()), suggestion, Severity.REFUSE);
    }
  }

  static boolean near(double factor, double unit) {
    return factor < unit * NEAR && factor > unit / NEAR;
  }

  private int firstMoving() {
    return pairs.stream()
        .filter(p -> Math.abs(p.command().speedMPerS()) > MOVES_M_S)
        .mapToInt(Pair::row)
        .findFirst()
        .orElse(0);
  }

  /** The turn that was seen over the one that was commanded. */
  private void headings() {
    double[] factors =
        pairs.stream()
            .filter(p -> turns(p))
            .mapToDouble(p -> p.turnRad() / p.seconds() / p.command().turnRadPerS())
            .toArray();
    if (factors.length < LEAST_PAIRS) {
      return;
    }
    double factor = median(factors);
    int row = pairs.stream().filter(TrackCheck::turns).mapToInt(Pair::row).findFirst().orElse(0);
    if (near(factor * 180 / Math.PI, 1) && !turnsAsItsWayBends()) {
      add(
          AuditCheck.TRACK_HEADING,
          String.format(
              Locale.ROOT,
              "the heading turns %.3g times as far as commanded: it looks like radians",
              factor),
          List.of(row),
          "write heading_deg in degrees: multiply by 57.29578",
          Severity.REFUSE);
    } else if (near(-factor, 1)) {
      add(
          AuditCheck.TRACK_FRAME,
          "the heading turns the other way than commanded",
          List.of(row),
          "headings and turns are counter-clockwise, seen from above: change the sign of"
              + " heading_deg, or of the commanded turns",
          Severity.REFUSE);
    }
  }

  /**
   * Tells whether the way bends about as far as the heading turns: then it is in degrees, and the
   * robot does not do what it is told. Without a way that bends there is nothing to tell by.
   */
  private boolean turnsAsItsWayBends() {
    double both = 0;
    double square = 0;
    for (int i = 1; i < pairs.size(); i++) {
      Pair before = pairs.get(i - 1);
      Pair after = pairs.get(i);
      boolean goes = before.to().equals(after.from()) && moves(before) && moves(after);
      if (goes && before.command().speedMPerS() * after.command().speedMPerS() > 0) {
        double turn = Math.IEEEremainder(after.heading() - before.heading(), 2 * Math.PI);
        both += turn * Math.IEEEremainder(after.course() - before.course(), 2 * Math.PI);
        square += turn * turn;
      }
    }
    return both > 0 && both < BENDS_AS_IT_TURNS * square;
  }

  private static boolean moves(Pair pair) {
    return pair.wayM() / pair.seconds() > MOVES_M_S;
  }

  /** Turns that are commanded far too fast, of which a 57th is seen. */
  private void turnUnit() {
    List<Pair> fast =
        pairs.stream()
            .filter(p -> Math.abs(p.command().turnRadPerS()) > TURNS_RAD_S && !turns(p))
            .toList();
    long degrees =
        fast.stream()
            .mapToDouble(p -> p.turnRad() / p.seconds() / p.command().turnRadPerS())
            .filter(factor -> near(factor * 180 / Math.PI, 1))
            .count();
    if (fast.size() >= LEAST_PAIRS && degrees > fast.size() / 2) {
      add(
          AuditCheck.TRACK_HEADING,
          "a 57th of the commanded turns is seen: they look like degrees a second",
          List.of(fast.get(0).row()),
          "write w_rad_s in radians a second: divide by 57.29578",
          Severity.REFUSE);
    }
  }

  private static boolean turns(Pair pair) {
    double turned = pair.command().turnRadPerS();
    return Math.abs(turned) > TURNS_RAD_S && Math.abs(turned) * pair.seconds() < 2;
  }

  /** The direction of the way less the heading, and with the heading mirrored. */
  private void frame() {
    double[] straight = new double[2];
    double[] mirrored = new double[2];
    int n = 0;
    for (Pair p : pairs) {
      double speed = p.command().speedMPerS();
      boolean brief = p.seconds() < 2 * PAIR_S;
      if (brief && Math.abs(speed) > MOVES_M_S && p.wayM() / p.seconds() > MOVES_M_S / 2) {
        double course = p.course() + (speed < 0 ? Math.PI : 0);
        add(straight, course - p.heading());
        add(mirrored, course + p.heading());
        n++;
      }
    }
    if (n < LEAST_PAIRS) {
      return;
    }
    double agrees = Math.hypot(straight[0], straight[1]) / n;
    double agreesMirrored = Math.hypot(mirrored[0], mirrored[1]) / n;
    double turned = Math.atan2(straight[1], straight[0]);
    List<Integer> row = List.of(firstMoving());
    if (agrees < AGREES - APART && agreesMirrored > AGREES) {
      add(
          AuditCheck.TRACK_FRAME,
          "the way goes where the mirrored heading points",
          row,
          "z points down the page: change the sign of z_m, or of heading_deg",
          Severity.REFUSE);
    } else if (agrees > AGREES && Math.abs(turned) > TURNED_RAD) {
      add(
          AuditCheck.TRACK_FRAME,
          String.format(
              Locale.ROOT,
              "the way goes %.0f degrees to the left of the heading",
              Math.toDegrees(turned)),
          row,
          "add that to heading_deg; the diagnosis calls it capture-offset",
          Severity.WARN);
    }
  }

  private static void add(double[] sum, double angle) {
    sum[0] += Math.cos(angle);
    sum[1] += Math.sin(angle);
  }

  /** A pose that is far from the one before and from the one after. */
  private void jumps(List<MotionRow<TrackPose>> rows) {
    double most = 0;
    for (List<MotionRow<Command>> run : commands.values()) {
      for (MotionRow<Command> row : run) {
        most = Math.max(most, Math.abs(row.value().speedMPerS()));
      }
    }
    List<Integer> jumped = new ArrayList<>();
    for (int i = 1; i + 1 < rows.size(); i++) {
      TrackPose before = rows.get(i - 1).value();
      TrackPose pose = rows.get(i).value();
      TrackPose after = rows.get(i + 1).value();
      double seconds = after.timeS() - before.timeS();
      double reach = JUMP_TIMES * Math.max(0.05, most * seconds);
      double there = Math.hypot(pose.xM() - before.xM(), pose.yM() - before.yM());
      double back = Math.hypot(after.xM() - pose.xM(), after.yM() - pose.yM());
      boolean flips =
          seconds < PAIR_S
              && turned(before, pose) > Math.PI / 2
              && turned(pose, after) > Math.PI / 2;
      if ((seconds < PAIR_S && there > reach && back > reach) || flips) {
        jumped.add(rows.get(i).row());
      }
    }
    if (!jumped.isEmpty()) {
      add(
          AuditCheck.TRACK_JUMP,
          (jumped.size() == 1 ? "1 pose is" : jumped.size() + " poses are")
              + " far from the one before and the one after",
          jumped,
          "leave them out; a heading that was averaged across 360 degrees looks like this too",
          Severity.WARN);
    }
  }

  private static double turned(TrackPose from, TrackPose to) {
    return Math.abs(Math.IEEEremainder(to.headingRad() - from.headingRad(), 2 * Math.PI));
  }

  /** Not a digit changes while the robot is told to go: the tracker repeats what it saw last. */
  private void still() {
    double seconds = 0;
    List<Integer> rows = new ArrayList<>();
    for (Map.Entry<String, List<MotionRow<TrackPose>>> run : track.entrySet()) {
      List<MotionRow<TrackPose>> sorted = MotionAudit.sorted(run.getValue());
      List<Command> told = told(run.getKey());
      int from = 0;
      for (int to = 1; to <= sorted.size(); to++) {
        if (to < sorted.size() && isSamePlace(sorted.get(from).value(), sorted.get(to).value())) {
          continue;
        }
        double begin = sorted.get(from).value().timeS();
        double end = sorted.get(to - 1).value().timeS();
        if (end - begin >= PAIR_S && toldToGo(told, begin, end) > PAIR_S / 2) {
          seconds += end - begin;
          // The first of them was seen.
          sorted.subList(from + 1, to).forEach(row -> rows.add(row.row()));
        }
        from = to;
      }
    }
    if (seconds > STILL_S) {
      rows.sort(null);
      add(
          AuditCheck.TRACK_STILL,
          String.format(
              Locale.ROOT,
              "the track does not move for %.1f s while the robot is told to drive",
              seconds),
          rows,
          "rows that only repeat the tracker's last value are left out of all that follows",
          Severity.WARN);
    }
  }

  private List<Command> told(String run) {
    return commands.getOrDefault(run, List.of()).stream()
        .map(MotionRow::value)
        .sorted(Comparator.comparingDouble(Command::timeS))
        .toList();
  }

  private static boolean isSamePlace(TrackPose a, TrackPose b) {
    return a.xM() == b.xM() && a.yM() == b.yM() && a.headingRad() == b.headingRad();
  }

  /** For how many seconds of a stretch the robot is told to go or to turn. */
  private static double toldToGo(List<Command> told, double begin, double end) {
    double seconds = 0;
    for (int i = 0; i < told.size(); i++) {
      Command one = told.get(i);
      double until = i + 1 < told.size() ? told.get(i + 1).timeS() : end;
      boolean goes =
          Math.abs(one.speedMPerS()) > MOVES_M_S || Math.abs(one.turnRadPerS()) > TURNS_RAD_S;
      seconds += goes ? Math.max(0, Math.min(end, until) - Math.max(begin, one.timeS())) : 0;
    }
    return seconds;
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private void add(
      AuditCheck check, String what, List<Integer> rows, String suggestion, Severity severity) {
    findings.add(
        new AuditFinding(check, AuditFinding.File.TRACK, what, rows, suggestion, "", severity));
  }
}
