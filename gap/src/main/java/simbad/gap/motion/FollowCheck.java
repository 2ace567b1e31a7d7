package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/**
 * Whether a track follows its commands at all. Speeds and turns of both are laid over each other as
 * in {@link LagCheck}, but over a whole run: a track of another drive is like its commands at no
 * lag. What hardly varies, or what a tracker hardly sees, says nothing.
 */
final class FollowCheck {
  /**
   * Of 60 practice worlds of SRB-1 (seed 785) no run has less than 0.83 in what it follows better,
   * a robot that loses half of its commands 0.54; of 282 pairs of one's commands and another's
   * track 255 have less than 0.3, 279 less than 0.4.
   */
  private static final double FOLLOWS = 0.35;

  /** Fewer changes are alike by chance. */
  private static final int LEAST_CHANGES = 40;

  private static final int LEAST_STEPS = (int) (60 / Lags.STEP_S);

  /** An hour tells it. */
  private static final int MOST_STEPS = (int) (3600 / Lags.STEP_S);

  /** Commands that vary by less, m/s and rad/s, need not show. */
  private static final double[] VARIES = {0.02, 0.1};

  /** A track that is less like itself a moment later is mostly the tracker's noise. */
  private static final double STEADY = 0.5;

  /** Nothing is faster than so many times the greatest command: else the tracker jumped. */
  private static final double JUMPS = 3;

  private final Lags.Grid grid;

  private FollowCheck(Lags.Grid grid) {
    this.grid = grid;
  }

  /** Looks at every run by itself. */
  static List<AuditFinding> of(
      Map<String, List<MotionRow<Command>>> commands,
      Map<String, List<MotionRow<TrackPose>>> track) {
    List<AuditFinding> found = new ArrayList<>();
    track.forEach(
        (run, rows) ->
            Lags.Grid.of(commands.getOrDefault(run, List.of()), rows)
                .flatMap(grid -> new FollowCheck(grid).finding(run, rows.get(0).row()))
                .ifPresent(found::add));
    return found;
  }

  private Optional<AuditFinding> finding(String run, int row) {
    OptionalDouble speed = speed();
    OptionalDouble turn = turn();
    boolean isSaid = speed.isPresent() || turn.isPresent();
    boolean isOther = speed.orElse(0) < FOLLOWS && turn.orElse(0) < FOLLOWS;
    return isSaid && isOther
        ? Optional.of(finding(run, row, words(speed, turn)))
        : Optional.empty();
  }

  private static String words(OptionalDouble speed, OptionalDouble turn) {
    List<String> words = new ArrayList<>();
    speed.ifPresent(r -> words.add(String.format(Locale.ROOT, "%.1f of speed", r)));
    turn.ifPresent(r -> words.add(String.format(Locale.ROOT, "%.1f of turn", r)));
    return String.join(", ", words);
  }

  private static AuditFinding finding(String run, int row, String alike) {
    return new AuditFinding(
        AuditCheck.TRACK_FOREIGN,
        AuditFinding.File.TRACK,
        "the track of run '" + run + "' hardly follows the commands (correlation " + alike + ")",
        List.of(row),
        "is it of another drive? put commands and track of one drive together; clocks that differ by more than "
            + Math.round(Lags.MOST_LAG * Lags.STEP_S)
            + " s look like this too",
        "",
        Severity.REFUSE);
  }

  /** How alike speeds are where they are most alike, with their signs or without. */
  private OptionalDouble speed() {
    OptionalDouble ahead = likest(grid.asked()[0], grid.did()[0], VARIES[0]);
    double[] sizes = Arrays.stream(grid.asked()[0]).map(Math::abs).toArray();
    OptionalDouble size = likest(sizes, grid.fast(), VARIES[0]);
    return ahead.isEmpty()
        ? size
        : OptionalDouble.of(Math.max(ahead.getAsDouble(), size.orElse(-1)));
  }

  private OptionalDouble turn() {
    return likest(grid.asked()[1], grid.did()[1], VARIES[1]);
  }

  /** The greatest correlation at any lag; empty where commands or tracker do not tell it. */
  private static OptionalDouble likest(double[] asked, double[] seen, double varies) {
    int length = Math.min(MOST_STEPS, asked.length - 2 * Lags.MOST_LAG);
    if (length < LEAST_STEPS || changes(asked) < LEAST_CHANGES) {
      return OptionalDouble.empty();
    }
    double most = JUMPS * known(asked).map(Math::abs).max().orElse(0);
    double[] did = Arrays.stream(seen).map(d -> Math.max(-most, Math.min(most, d))).toArray();
    double itself = Lags.correlation(did, did, Lags.MOST_LAG, length, 2 * Lags.OVER);
    if (!(deviation(asked) > varies && itself > STEADY)) {
      return OptionalDouble.empty();
    }
    double best = 0;
    for (int lag = -Lags.MOST_LAG; lag <= Lags.MOST_LAG; lag++) {
      double alike = Lags.correlation(asked, did, Lags.MOST_LAG, length, lag);
      best = alike > best ? alike : best;
    }
    return OptionalDouble.of(best);
  }

  private static int changes(double[] asked) {
    int changes = 0;
    for (int i = 1; i < asked.length; i++) {
      changes += Math.abs(asked[i] - asked[i - 1]) > 0 ? 1 : 0;
    }
    return changes;
  }

  private static double deviation(double[] asked) {
    double mean = known(asked).average().orElse(0);
    return Math.sqrt(known(asked).map(a -> (a - mean) * (a - mean)).average().orElse(0));
  }

  private static DoubleStream known(double[] asked) {
    return Arrays.stream(asked).filter(a -> !Double.isNaN(a));
  }
}
