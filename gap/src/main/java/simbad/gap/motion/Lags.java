package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/**
 * By how much a track is later than its commands, piece by piece of a run: speeds and turn rates of
 * both are laid over each other.
 */
final class Lags {
  /** What a lag is rounded to at worst, seconds. */
  static final double STEP_S = 0.05;

  /** The greatest lag that is tried, in steps. */
  static final int MOST_LAG = 160;

  /** Speeds of a track are taken over so many steps, which is one of motion capture's noise. */
  static final int OVER = 4;

  private static final double LEAST_PIECE_S = 15;
  private static final double MOST_PIECE_S = 60;
  private static final int PIECES = 10;

  /** Less alike is no likeness. */
  private static final double ALIKE = 0.6;

  /** Another lag, this far away, must be less alike by so much: else commands repeat themselves. */
  private static final double ALONE = 0.1;

  private static final int APART = 20;

  private Lags() {}

  /**
   * Of a piece of a run.
   *
   * @param row of the track where it begins
   * @param timeS of its middle
   * @param lagS by which the track is later
   */
  record Piece(int row, double timeS, double lagS) {}

  /**
   * Lays one run of commands and track over each other.
   *
   * @param commands in any order
   * @param track in any order
   * @return pieces that tell a lag, in the order of time
   */
  static List<Piece> of(List<MotionRow<Command>> commands, List<MotionRow<TrackPose>> track) {
    return Grid.of(commands, track).map(Lags::lay).orElse(List.of());
  }

  /**
   * Speeds and turn rates of a run, step by step.
   *
   * @param seen the track in the order of time
   * @param asked speed and turn rate that were asked for; NaN before the first command
   * @param did the same as the track shows it; NaN in holes
   * @param fast the speed whichever way the robot went
   */
  @SuppressWarnings("ArrayRecordComponent") // Never compared.
  record Grid(List<MotionRow<TrackPose>> seen, double[][] asked, double[][] did, double[] fast) {
    /** Lays a grid over a run, if it has two commands and two poses. */
    static Optional<Grid> of(List<MotionRow<Command>> commands, List<MotionRow<TrackPose>> track) {
      List<Command> told =
          commands.stream()
              .map(MotionRow::value)
              .sorted(Comparator.comparingDouble(Command::timeS))
              .toList();
      List<MotionRow<TrackPose>> seen = MotionAudit.sorted(track);
      if (told.size() < 2 || seen.size() < 2) {
        return Optional.empty();
      }
      double first = seen.get(0).value().timeS();
      double last = seen.get(seen.size() - 1).value().timeS();
      int steps = (int) Math.min(4e6, (last - first) / STEP_S);
      double[][] did = Lags.did(seen, first, steps);
      return Optional.of(
          new Grid(seen, Lags.asked(told, first, steps), new double[][] {did[0], did[1]}, did[2]));
    }

    double firstS() {
      return seen.get(0).value().timeS();
    }

    double lastS() {
      return seen.get(seen.size() - 1).value().timeS();
    }
  }

  private static List<Piece> lay(Grid grid) {
    List<MotionRow<TrackPose>> seen = grid.seen();
    double first = grid.firstS();
    double last = grid.lastS();
    double[][] asked = grid.asked();
    double[][] did = grid.did();
    int steps = asked[0].length;
    double pieceS = Math.max(LEAST_PIECE_S, Math.min(MOST_PIECE_S, (last - first) / PIECES));
    int length = (int) (pieceS / STEP_S);
    List<Piece> pieces = new ArrayList<>();
    for (int from = MOST_LAG; from + length + MOST_LAG < steps; from += length) {
      int at = from;
      OptionalDouble lag = lag(asked, did, at, length);
      double middle = first + (from + length / 2.0) * STEP_S;
      lag.ifPresent(s -> pieces.add(new Piece(row(seen, first + at * STEP_S), middle, s)));
    }
    return pieces;
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

  /**
   * The same as the track shows it, between poses that are near enough, and the speed whichever way
   * the robot went; NaN in holes.
   */
  private static double[][] did(List<MotionRow<TrackPose>> seen, double first, int steps) {
    double[][] did = new double[3][steps];
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
      did[2][i] = near ? Math.hypot(b.xM() - a.xM(), b.yM() - a.yM()) / seconds : Double.NaN;
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
  static double correlation(double[] asked, double[] did, int from, int length, int lag) {
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
}
