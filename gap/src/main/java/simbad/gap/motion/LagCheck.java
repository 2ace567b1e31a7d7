package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.fit.Robust;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/**
 * By how much the track is later than the commands, piece by piece of a run: speeds and turn rates
 * of both are laid over each other. One clock has one lag. A lag that jumps or grows with time is
 * that of a second clock, and what is fitted to it means nothing.
 */
final class LagCheck {
  private static final double STEP_S = 0.05;
  private static final int MOST_LAG = 160;

  /** Speeds of a track are taken over so many steps, which is one of motion capture's noise. */
  private static final int OVER = 4;

  private static final double LEAST_PIECE_S = 15;
  private static final double MOST_PIECE_S = 60;
  private static final int PIECES = 10;
  private static final int LEAST_PIECES = 4;
  private static final int LEAST_PAIRS = 6;

  /** Less alike is no likeness. */
  private static final double ALIKE = 0.6;

  /** Another lag, this far away, must be less alike by so much: else commands repeat themselves. */
  private static final double ALONE = 0.1;

  private static final int APART = 20;

  /** What a robot's own latency may change by, and how well a piece tells it. */
  private static final double JUMP_S = 0.7;

  /** Clocks that differ by more are seen in the lag; two quartz clocks differ by a 10,000th. */
  private static final double DRIFT_S = 0.7;

  /** In standard errors. */
  private static final double SURE = 6;

  /** No robot is later, and none begins before it is told. */
  private static final double LATEST_S = 2.2;

  private static final double EARLIEST_S = -0.2;

  private final List<Piece> pieces = new ArrayList<>();
  private final double begins;

  /**
   * Of a piece of a run.
   *
   * @param row of the track where it begins
   * @param timeS of its middle
   * @param lagS by which the track is later
   */
  private record Piece(int row, double timeS, double lagS) {}

  /** Lays one run of commands and track over each other, each in any order. */
  LagCheck(List<MotionRow<Command>> commands, List<MotionRow<TrackPose>> track) {
    List<Command> told =
        commands.stream()
            .map(MotionRow::value)
            .sorted(Comparator.comparingDouble(Command::timeS))
            .toList();
    List<MotionRow<TrackPose>> seen = MotionAudit.sorted(track);
    begins = seen.isEmpty() ? 0 : seen.get(0).value().timeS();
    if (told.size() > 1 && seen.size() > 1) {
      lay(told, seen);
    }
  }

  private void lay(List<Command> told, List<MotionRow<TrackPose>> seen) {
    double first = begins;
    double last = seen.get(seen.size() - 1).value().timeS();
    int steps = (int) Math.min(4e6, (last - first) / STEP_S);
    double[][] asked = asked(told, first, steps);
    double[][] did = did(seen, first, steps);
    double pieceS = Math.max(LEAST_PIECE_S, Math.min(MOST_PIECE_S, (last - first) / PIECES));
    int length = (int) (pieceS / STEP_S);
    for (int from = MOST_LAG; from + length + MOST_LAG < steps; from += length) {
      int at = from;
      OptionalDouble lag = lag(asked, did, at, length);
      double middle = first + (from + length / 2.0) * STEP_S;
      lag.ifPresent(s -> pieces.add(new Piece(row(seen, first + at * STEP_S), middle, s)));
    }
  }

  private static int row(List<MotionRow<TrackPose>> seen, double timeS) {
    return seen.stream()
        .filter(one -> one.value().timeS() >= timeS)
        .findFirst()
        .orElse(seen.get(seen.size() - 1))
        .row();
  }

  /** Speed and turn rate that were asked for, step by step; NaN before the first command. */
  private static double[][] asked(List<Command> told, double first, int steps) {
    double[][] asked = new double[2][steps];
    int at = -1;
    for (int i = 0; i < steps; i++) {
      double time = first + (i + 0.5) * STEP_S;
      while (at + 1 < told.size() && told.get(at + 1).timeS() <= time) {
        at++;
      }
      asked[0][i] = at < 0 ? Double.NaN : told.get(at).speedMPerS();
      asked[1][i] = at < 0 ? Double.NaN : told.get(at).turnRadPerS();
    }
    return asked;
  }

  /** The same as the track shows it, between poses that are near enough; NaN in holes. */
  private static double[][] did(List<MotionRow<TrackPose>> seen, double first, int steps) {
    double[][] did = new double[2][steps];
    int from = 0;
    int to = 0;
    for (int i = 0; i < steps; i++) {
      double middle = first + (i + 0.5) * STEP_S;
      double half = OVER * STEP_S / 2;
      while (from + 1 < seen.size() && seen.get(from + 1).value().timeS() <= middle - half) {
        from++;
      }
      while (to + 1 < seen.size() && seen.get(to).value().timeS() < middle + half) {
        to++;
      }
      TrackPose a = seen.get(from).value();
      TrackPose b = seen.get(to).value();
      double seconds = b.timeS() - a.timeS();
      boolean near = seconds > 0 && seconds < 2 * OVER * STEP_S;
      double course = (a.headingRad() + b.headingRad()) / 2;
      double way = (b.xM() - a.xM()) * Math.cos(course) + (b.yM() - a.yM()) * Math.sin(course);
      double turn = Math.IEEEremainder(b.headingRad() - a.headingRad(), 2 * Math.PI);
      // Where a heading wraps between the two their mean points the other way.
      boolean wraps = Math.abs(b.headingRad() - a.headingRad()) > Math.PI;
      did[0][i] = near ? (wraps ? -way : way) / seconds : Double.NaN;
      did[1][i] = near ? turn / seconds : Double.NaN;
    }
    return did;
  }

  /** The lag at which both are most alike, if they are at one only. */
  private static OptionalDouble lag(double[][] asked, double[][] did, int from, int length) {
    double[] alike = new double[2 * MOST_LAG + 1];
    for (int k = 0; k < alike.length; k++) {
      alike[k] = alike(asked, did, from, length, k - MOST_LAG);
    }
    int best = 0;
    for (int k = 1; k < alike.length; k++) {
      best = alike[k] > alike[best] ? k : best;
    }
    double other = -1;
    for (int k = 0; k < alike.length; k++) {
      other = Math.abs(k - best) > APART ? Math.max(other, alike[k]) : other;
    }
    boolean plain =
        alike[best] > ALIKE && alike[best] > other + ALONE && best > 0 && best < alike.length - 1;
    if (!plain) {
      return OptionalDouble.empty();
    }
    // A parabola through three points has its top between two steps.
    double bend = alike[best - 1] - 2 * alike[best] + alike[best + 1];
    double off = bend < 0 ? (alike[best - 1] - alike[best + 1]) / (2 * bend) : 0;
    return OptionalDouble.of((best - MOST_LAG + off) * STEP_S);
  }

  /** The correlation of what was asked and what was done so many steps later, of both together. */
  private static double alike(double[][] asked, double[][] did, int from, int length, int lag) {
    double sum = 0;
    int channels = 0;
    for (int channel = 0; channel < 2; channel++) {
      double r = correlation(asked[channel], did[channel], from, length, lag);
      if (!Double.isNaN(r)) {
        sum += r;
        channels++;
      }
    }
    return channels == 0 ? 0 : sum / channels;
  }

  /** NaN where one of them stands still, or most of it was not seen. */
  private static double correlation(double[] asked, double[] did, int from, int length, int lag) {
    double n = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (int i = from; i < from + length; i++) {
      double a = asked[i];
      double b = did[i + lag];
      if (!Double.isNaN(a + b)) {
        n++;
        x += a;
        y += b;
        xx += a * a;
        yy += b * b;
        xy += a * b;
      }
    }
    double spreadX = xx - x * x / n;
    double spreadY = yy - y * y / n;
    boolean isSeen = 2 * n > length && spreadX > 1e-6 * n && spreadY > 1e-6 * n;
    return isSeen ? (xy - x * y / n) / Math.sqrt(spreadX * spreadY) : Double.NaN;
  }

  private static double[] lags(List<Piece> pieces) {
    return pieces.stream().mapToDouble(Piece::lagS).toArray();
  }

  /** How far pieces are from their median, in the mean. */
  private static double scatter(List<Piece> pieces, double middle) {
    return scatter(pieces.stream().mapToDouble(one -> Math.abs(one.lagS - middle)).toArray());
  }

  /** A standard deviation from distances to the middle, at least what a step hides. */
  private static double scatter(double... off) {
    return Math.max(STEP_S / 2, Robust.NORMAL_OVER_MAD * Robust.median(off));
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
    return some.stream().mapToDouble(one -> Math.abs(one.lagS - middle)).sum();
  }

  private static AuditFinding jumpFinding(String run, Piece from, double was, double is) {
    return finding(
        List.of(from.row),
        String.format(
            Locale.ROOT,
            "the track of run '%s' is %.2f s later than its commands until about %.0f s, and %.2f s"
                + " later afterwards: a clock jumped by %.2f s",
            run,
            was,
            from.timeS,
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
          double apart = all.get(i).timeS - all.get(j).timeS;
          slopes.add((all.get(i).lagS - all.get(j).lagS) / apart);
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
        ? Optional.of(driftFinding(runs.get(0).pieces.get(0).row, slope, error, grown))
        : Optional.empty();
  }

  /** The standard error of a common slope of runs that each have a lag of their own. */
  private static double slopeError(List<LagCheck> runs, double slope) {
    List<Double> off = new ArrayList<>();
    double spread = 0;
    for (LagCheck run : runs) {
      double[] rest = run.pieces.stream().mapToDouble(p -> p.lagS - slope * p.timeS).toArray();
      double middle = Robust.median(rest);
      double mean = run.pieces.stream().mapToDouble(Piece::timeS).average().orElse(0);
      for (int i = 0; i < rest.length; i++) {
        off.add(Math.abs(rest[i] - middle));
        spread += Math.pow(run.pieces.get(i).timeS - mean, 2);
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
                List.of(runs.get(0).pieces.get(0).row),
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
          LagCheck one = new LagCheck(commands.getOrDefault(run, List.of()), rows);
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
