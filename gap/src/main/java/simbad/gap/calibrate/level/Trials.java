package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import simbad.gap.fit.Fold;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SonarSpec;

/**
 * What each ping of a log says of each obstacle: its echo was read, or was not, though it would
 * have been read. What a nearer echo hides was not tried.
 */
final class Trials {
  /** What was read further from every obstacle's nearest point has to do with none of them. */
  private static final double NEAR_M = 0.2;

  /** Echoes that are no further apart are one event at the receiver. */
  private static final double SAME_M = 0.035;

  private final List<Trial> all = new ArrayList<>();

  /**
   * One ping and one obstacle.
   *
   * @param ping index in the log
   * @param target index of the obstacle
   * @param bearingRad of the sensor in the obstacle's frame
   * @param centreM distance to the obstacle's centre, metres
   * @param nearestM distance to the nearest point of its outline, metres
   * @param offAxisRad of where its echo comes from, positive counter-clockwise
   * @param isRead whether its echo was read
   * @param addedDb what the near field and effects add to the excess, decibels
   * @param share what effects leave of the chance of an echo, in [0, 1]
   * @param beyondM by how much the reading is longer than the nearest point's distance, metres; of
   *     no meaning where it was not read
   */
  record Trial(
      int ping,
      int target,
      double bearingRad,
      double centreM,
      double nearestM,
      double offAxisRad,
      boolean isRead,
      double addedDb,
      double share,
      double beyondM) {
    Trial plus(double moreDb, double newShare, double newBeyondM) {
      return new Trial(
          ping,
          target,
          bearingRad,
          centreM,
          nearestM,
          offAxisRad,
          isRead,
          addedDb + moreDb,
          newShare,
          newBeyondM);
    }
  }

  private final List<? extends Change> effects;

  private Trials(Geometry geometry, SonarSpec sensor, Fold fold, List<? extends Change> effects) {
    this.effects = effects;
    for (int ping = 0; ping < geometry.log().size(); ping++) {
      if (fold.holds(ping)) {
        add(geometry, sensor, ping);
      }
    }
  }

  /**
   * Reads a log.
   *
   * @param geometry of the log, with all before the sensor in the cone
   * @param sensor whose range and resolution count
   * @param fold the pings that count
   * @param effects at work, of which those on levels and chances count here
   */
  static List<Trial> of(
      Geometry geometry, SonarSpec sensor, Fold fold, List<? extends Change> effects) {
    return List.copyOf(new Trials(geometry, sensor, fold, effects).all);
  }

  private void add(Geometry geometry, SonarSpec sensor, int ping) {
    PingLog log = geometry.log();
    // Rounded down: on average half a step short.
    double read = log.rangeM(ping) + sensor.resolutionM() / 2;
    int answered = log.echo(ping) ? answered(geometry, ping, read) : -1;
    if (log.echo(ping) && answered < 0) {
      return;
    }
    for (int target = 0; target < geometry.obstacles(); target++) {
      double nearest = geometry.nearestM(ping * geometry.obstacles() + target);
      boolean inRange = nearest >= sensor.minRangeM() && nearest <= sensor.maxRangeM();
      boolean tried =
          answered < 0 || target == answered || isBefore(geometry, ping, target, answered);
      if (inRange && tried) {
        add(geometry, ping, target, target == answered, read - nearest);
      }
    }
  }

  private void add(Geometry geometry, int ping, int target, boolean isRead, double beyondM) {
    int line = ping * geometry.obstacles() + target;
    double added = geometry.addedDb(effects, line);
    double share = geometry.share(effects, line);
    all.add(trial(geometry, line, isRead).plus(added, share, beyondM));
  }

  /** Reads one line of sight, without effects. */
  static Trial trial(Geometry geometry, int line, boolean isRead) {
    return new Trial(
        line / geometry.obstacles(),
        line % geometry.obstacles(),
        geometry.bearingRad(line),
        geometry.centreDistanceM(line),
        geometry.nearestM(line),
        geometry.echoOffAxisRad(line),
        isRead,
        Objects.requireNonNull(geometry.ears()).nearDb(geometry, line),
        1,
        0);
  }

  private static boolean isBefore(Geometry geometry, int ping, int target, int answered) {
    int first = ping * geometry.obstacles();
    return geometry.nearestM(first + target) < geometry.nearestM(first + answered) - SAME_M;
  }

  /** The obstacle whose nearest point is nearest to what was read; -1 for none. */
  private static int answered(Geometry geometry, int ping, double readM) {
    int answered = -1;
    double off = NEAR_M;
    for (int target = 0; target < geometry.obstacles(); target++) {
      double own = Math.abs(geometry.nearestM(ping * geometry.obstacles() + target) - readM);
      if (own < off) {
        off = own;
        answered = target;
      }
    }
    return answered;
  }
}
