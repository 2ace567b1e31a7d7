package simbad.sonar.ping;

import java.util.List;

/**
 * Where the sensors of a log were under changes of their poses, ping by ping. Where poses are
 * written late the log says where a sensor was, between poses in proportion; at the end of a run it
 * does not.
 */
final class LoggedPoses {
  private final PingLog log;
  private final List<PoseChange> all;
  private final List<PoseChange> others;
  private final double aheadS;
  private final TruePose before = new TruePose();
  private final TruePose after = new TruePose();
  private PoseTrack track;
  private PoseTrack known;

  /** The first ping of the sequence that is not earlier than what was looked for last. */
  private int at;

  LoggedPoses(PingLog log, List<? extends Change> changes) {
    this.log = log;
    all = Change.only(PoseChange.class, changes);
    others = all.stream().filter(change -> change.aheadS() == 0).toList();
    aheadS = all.stream().mapToDouble(PoseChange::aheadS).sum();
    track = new PoseTrack(all, "", 0);
    known = track;
  }

  /**
   * Puts a pose where the sensor was.
   *
   * @param ping the next one
   * @param pose that is put there
   */
  void next(int ping, TruePose pose) {
    if (log.sequenceStart(ping) == ping) {
      String label = log.sensors().get(log.sensor(ping));
      track = new PoseTrack(all, label, log.runStartS(ping));
      known = aheadS == 0 ? track : new PoseTrack(others, label, log.runStartS(ping));
    }
    put(ping, pose);
    if (aheadS == 0) {
      track.next(log.timeS(ping), pose);
      return;
    }
    // Both tracks go on: the log ends before what comes after it.
    TruePose later = new TruePose();
    boolean isKnown = putLater(ping, later);
    track.next(log.timeS(ping), pose);
    if (isKnown) {
      known.next(log.timeS(ping), later);
      pose.set(later);
    }
  }

  private void put(int ping, TruePose pose) {
    pose.set(log.xM(ping), log.zM(ping), log.headingRad(ping));
  }

  /** Returns false where the log ends before. */
  private boolean putLater(int ping, TruePose pose) {
    double then = log.timeS(ping) + aheadS;
    at = Math.max(at, ping);
    while (isSame(at, ping) && log.timeS(at) < then) {
      at++;
    }
    if (!isSame(at, ping)) {
      return false;
    }
    // So little later that the clock does not show it.
    if (at == ping) {
      put(ping, pose);
      return true;
    }
    put(at - 1, before);
    put(at, after);
    double gapS = log.timeS(at) - log.timeS(at - 1);
    pose.setBetween(before, after, 1 - (log.timeS(at) - then) / gapS);
    return true;
  }

  private boolean isSame(int one, int other) {
    return one < log.size() && log.sequenceStart(one) == log.sequenceStart(other);
  }
}
