package simbad.motion.forecast;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.motion.Displacement;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/** Cuts runs into windows that begin at every half second at which the track is known. */
public final class Windows {
  private static final double[] HORIZONS_S = {0.5, 2, 5};
  private static final double EVERY_S = 0.5;
  private static final double KNOWN_S = 0.02;

  /** Over a longer hole nothing is interpolated: the nearer pose counts as it stands. */
  private static final double HOLE_S = 0.1;

  private Windows() {}

  /** Returns how long the windows of a gap are, seconds, ascending. */
  public static double[] horizonsS() {
    return HORIZONS_S.clone();
  }

  /**
   * Cuts runs into windows.
   *
   * @param runs in whose order the windows come, then by time
   * @param horizonS how long the windows are
   */
  public static List<Window> of(List<MotionRun> runs, double horizonS) {
    List<Window> windows = new ArrayList<>();
    for (int run = 0; run < runs.size(); run++) {
      cut(runs.get(run), run, horizonS, windows);
    }
    return windows;
  }

  private static void cut(MotionRun run, int index, double horizonS, List<Window> windows) {
    if (run.track().isEmpty()) {
      return;
    }
    Known from = new Known(run.track());
    Known to = new Known(run.track());
    double first = run.commands().get(0).timeS();
    double last = run.track().get(run.track().size() - 1).timeS();
    long begin = (long) Math.ceil(Math.max(first, run.track().get(0).timeS() - 1) / EVERY_S);
    for (long i = begin; i * EVERY_S + horizonS <= last + KNOWN_S; i++) {
      double start = i * EVERY_S;
      Optional<TrackPose> a = from.at(start);
      Optional<TrackPose> b = to.at(start + horizonS);
      if (a.isPresent() && b.isPresent()) {
        TrackPose pose = a.get();
        Displacement way = Displacement.between(pose, b.get());
        windows.add(
            new Window(index, start, horizonS, pose.headingRad(), pose.xM(), pose.yM(), way));
      }
    }
  }

  /** The track at times that only grow. */
  private static final class Known {
    private final List<TrackPose> track;
    private int at;

    Known(List<TrackPose> track) {
      this.track = track;
    }

    Optional<TrackPose> at(double timeS) {
      while (at + 1 < track.size() && track.get(at + 1).timeS() <= timeS) {
        at++;
      }
      TrackPose before = track.get(at);
      TrackPose after = track.get(Math.min(at + 1, track.size() - 1));
      TrackPose near =
          Math.abs(before.timeS() - timeS) <= Math.abs(after.timeS() - timeS) ? before : after;
      if (Math.abs(near.timeS() - timeS) > KNOWN_S) {
        return Optional.empty();
      }
      double gap = after.timeS() - before.timeS();
      boolean between = before.timeS() <= timeS && gap > 0 && gap <= HOLE_S;
      return Optional.of(between ? mix(before, after, (timeS - before.timeS()) / gap) : near);
    }

    private static TrackPose mix(TrackPose a, TrackPose b, double share) {
      double turn = Math.IEEEremainder(b.headingRad() - a.headingRad(), 2 * Math.PI);
      return new TrackPose(
          a.timeS() + share * (b.timeS() - a.timeS()),
          a.xM() + share * (b.xM() - a.xM()),
          a.yM() + share * (b.yM() - a.yM()),
          a.headingRad() + share * turn);
    }
  }
}
