package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.fit.Robust;
import simbad.gap.motion.Lags.Piece;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/**
 * Whether commands and track have one clock, which has one lag. A lag that jumps or grows with time
 * is that of a second clock, and what is fitted to it means nothing.
 */
final class LagCheck {
  private static final int LEAST_PIECES = 4;
  private static final int LEAST_PAIRS = 6;

  /** What a robot's own latency may change by, and how well a piece tells it. */
  private static final double JUMP_S = 0.7;

  /** Clocks that differ by more are seen in the lag; two quartz clocks differ by a 10,000th. */
  private static final double DRIFT_S = 0.7;

  /** In standard errors. */
  private static final double SURE = 6;

  /** No robot is later, and none begins before it is told. */
  private static final double LATEST_S = 2.2;

  private static final double EARLIEST_S = -0.2;

  private final List<Piece> pieces;

  /** Prepares the check of one run. */
  private LagCheck(List<Piece> pieces) {
    this.pieces = pieces;
  }

  private static double[] lags(List<Piece> pieces) {
    return pieces.stream().mapToDouble(Piece::lagS).toArray();
  }

  /** How far pieces are from their median, in the mean. */
  private static double scatter(List<Piece> pieces, double middle) {
    return scatter(pieces.stream().mapToDouble(one -> Math.abs(one.lagS() - middle)).toArray());
  }

  /** A standard deviation from distances to the middle, at least what a step hides. */
  private static double scatter(double... off) {
    return Math.max(Lags.STEP_S / 2, Robust.NORMAL_OVER_MAD * Robust.median(off));
  }

  /** Two stretches of steady lags that differ: cut where the lags of each are most alike. */
  private Optional<AuditFinding> jump(String run) {
    if (pieces.size() < LEAST_PIECES) {
      return Optional.empty();
    }
    int cut =
        IntStream.rangeClosed(2, pieces.size() - 2)
            .boxed()
            .min(
                Comparator.comparingDouble(
                    at -> off(pieces.subList(0, at)) + off(pieces.subList(at, pieces.size()))))
            .orElseThrow();
    List<Piece> before = pieces.subList(0, cut);
    List<Piece> after = pieces.subList(cut, pieces.size());
    double was = Robust.median(lags(before));
    double is = Robust.median(lags(after));
    double size = Math.abs(is - was);
    return size > JUMP_S && size > SURE * Math.max(scatter(before, was), scatter(after, is))
        ? Optional.of(jumpFinding(run, after.get(0), was, is))
        : Optional.empty();
  }

  /** How far lags are from their median, all together. */
  private static double off(List<Piece> some) {
    double middle = Robust.median(lags(some));
    return some.stream().mapToDouble(one -> Math.abs(one.lagS() - middle)).sum();
  }

  private static AuditFinding jumpFinding(String run, Piece from, double was, double is) {
    return finding(
        List.of(from.row()),
        String.format(
            Locale.ROOT,
            "the track of run '%s' is %.2f s later than its commands until about %.0f s, and %.2f s"
                + " later afterwards: a clock jumped by %.2f s",
            run,
            was,
            from.timeS(),
            is,
            is - was),
        "add "
            + seconds(was - is)
            + " to the track's t_s from there on, or give the rows after it, of commands and track,"
            + " another run name");
  }

  /** A lag that grows evenly, in every run alike. */
  private static Optional<AuditFinding> drift(List<LagCheck> runs) {
    List<Double> slopes = new ArrayList<>();
    double longest = 0;
    for (LagCheck run : runs) {
      List<Piece> all = run.pieces;
      for (int i = 0; i < all.size(); i++) {
        for (int j = 0; j < i; j++) {
          double apart = all.get(i).timeS() - all.get(j).timeS();
          slopes.add((all.get(i).lagS() - all.get(j).lagS()) / apart);
          longest = Math.max(longest, apart);
        }
      }
    }
    double slope = Robust.median(slopes.stream().mapToDouble(Double::doubleValue).toArray());
    double error = slopeError(runs, slope);
    double grown = slope * longest;
    boolean shows =
        slopes.size() >= LEAST_PAIRS && Math.abs(grown) > DRIFT_S && Math.abs(slope) > SURE * error;
    return shows
        ? Optional.of(driftFinding(runs.get(0).pieces.get(0).row(), slope, error, grown))
        : Optional.empty();
  }

  /** The standard error of a common slope of runs that each have a lag of their own. */
  private static double slopeError(List<LagCheck> runs, double slope) {
    List<Double> off = new ArrayList<>();
    double spread = 0;
    for (LagCheck run : runs) {
      double[] rest = run.pieces.stream().mapToDouble(p -> p.lagS() - slope * p.timeS()).toArray();
      double middle = Robust.median(rest);
      double mean = run.pieces.stream().mapToDouble(Piece::timeS).average().orElse(0);
      for (int i = 0; i < rest.length; i++) {
        off.add(Math.abs(rest[i] - middle));
        spread += Math.pow(run.pieces.get(i).timeS() - mean, 2);
      }
    }
    return scatter(off.stream().mapToDouble(Double::doubleValue).toArray()) / Math.sqrt(spread);
  }

  private static AuditFinding driftFinding(int row, double slope, double error, double grown) {
    return finding(
        List.of(row),
        String.format(
            Locale.ROOT,
            "the track falls behind its commands by %.4f s in each second (standard error %.4f),"
                + " %.2f s in its longest run: the two clocks do not run alike",
            slope,
            error,
            grown),
        String.format(Locale.ROOT, "multiply the track's t_s by %.5f", 1 / (1 + slope)));
  }

  /** A lag that no robot has. */
  private static Optional<AuditFinding> offset(List<LagCheck> runs) {
    double[] lags =
        runs.stream().flatMap(run -> run.pieces.stream()).mapToDouble(Piece::lagS).toArray();
    double lag = Robust.median(lags);
    double[] off = Arrays.stream(lags).map(one -> Math.abs(one - lag)).toArray();
    double error = scatter(off) / Math.sqrt(lags.length);
    boolean early = lag + SURE * error < EARLIEST_S;
    boolean late = lag - SURE * error > LATEST_S;
    return (early || late) && lags.length >= LEAST_PIECES
        ? Optional.of(
            finding(
                List.of(runs.get(0).pieces.get(0).row()),
                String.format(
                    Locale.ROOT,
                    early
                        ? "the robot does what it is told %.2f s before it is told"
                        : "the robot does what it is told %.2f s later, which none does",
                    Math.abs(lag)),
                "add "
                    + seconds(-lag)
                    + " to the track's t_s, or write \"clocks\": \"separate\" in robot.json"))
        : Optional.empty();
  }

  private static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.2f s", seconds);
  }

  private static AuditFinding finding(List<Integer> rows, String what, String suggestion) {
    return new AuditFinding(
        AuditCheck.TRACK_CLOCK,
        AuditFinding.File.TRACK,
        what,
        rows,
        suggestion,
        "",
        Severity.REFUSE);
  }

  /**
   * Looks at every run, then at all of them together.
   *
   * @param commands by run
   * @param track by run
   * @param isOneClock whether the clocks of both are said to be one
   */
  static List<AuditFinding> of(
      Map<String, List<MotionRow<Command>>> commands,
      Map<String, List<MotionRow<TrackPose>>> track,
      boolean isOneClock) {
    List<AuditFinding> found = new ArrayList<>();
    List<LagCheck> runs = new ArrayList<>();
    track.forEach(
        (run, rows) -> {
          LagCheck one = new LagCheck(Lags.of(commands.getOrDefault(run, List.of()), rows));
          one.jump(run).ifPresent(found::add);
          if (!one.pieces.isEmpty()) {
            runs.add(one);
          }
        });
    if (found.isEmpty() && !runs.isEmpty()) {
      drift(runs).or(() -> isOneClock ? offset(runs) : Optional.empty()).ifPresent(found::add);
    }
    return found;
  }
}
