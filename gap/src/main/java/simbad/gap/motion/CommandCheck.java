package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.format.MotionRow;

/** Whether a robot can do what it is told. Units that commands and track share show here alone. */
final class CommandCheck {
  /** Cars of a racing class do 20 m/s; a robot that is indoors before a tracker does not. */
  private static final double FASTEST_M_S = 20;

  /** Ten turns a second. */
  private static final double FASTEST_RAD_S = 60;

  /** Fewer of the commands that move it are slips of a keyboard or of a cable. */
  private static final double SHARE = 0.1;

  private static final int LISTED = 1000;

  private static final List<Limit> LIMITS =
      List.of(
          new Limit(Command::speedMPerS, FASTEST_M_S, "m/s", "speeds look like millimetres"),
          new Limit(Command::turnRadPerS, FASTEST_RAD_S, "rad/s", "turns look like degrees"));

  private CommandCheck() {}

  /** What is asked for, the most of it, its unit, and what it looks like beyond. */
  private record Limit(
      ToDoubleFunction<Command> asked, double most, String unit, String looksLike) {}

  /** Looks at the commands of all runs together. */
  static List<AuditFinding> of(Map<String, List<MotionRow<Command>>> commands) {
    return LIMITS.stream().flatMap(limit -> beyond(limit, commands).stream()).toList();
  }

  private static Optional<AuditFinding> beyond(
      Limit limit, Map<String, List<MotionRow<Command>>> commands) {
    List<Integer> rows = new ArrayList<>();
    double most = 0;
    int moving = 0;
    for (List<MotionRow<Command>> run : commands.values()) {
      for (MotionRow<Command> row : run) {
        double asked = Math.abs(limit.asked().applyAsDouble(row.value()));
        most = Math.max(most, asked);
        moving += asked > 0 ? 1 : 0;
        if (asked > limit.most()) {
          rows.add(row.row());
        }
      }
    }
    return rows.isEmpty()
        ? Optional.empty()
        : Optional.of(finding(limit, rows, most, rows.size() > SHARE * moving));
  }

  private static AuditFinding finding(
      Limit limit, List<Integer> rows, double most, boolean isUnit) {
    String what =
        String.format(
            Locale.ROOT,
            "up to %.4g %s is commanded, which no such robot does",
            most,
            limit.unit());
    return new AuditFinding(
        AuditCheck.COMMAND_UNIT,
        AuditFinding.File.COMMANDS,
        isUnit ? what + ": " + limit.looksLike() : what,
        rows.stream().sorted().limit(LISTED).toList(),
        isUnit
            ? "write metres and radians, in commands and track alike: simbad dataset motion csv"
                + " takes other units with --speed-unit, --turn-unit and --place-unit"
            : "leave these rows out",
        "",
        isUnit ? Severity.REFUSE : Severity.WARN);
  }
}
