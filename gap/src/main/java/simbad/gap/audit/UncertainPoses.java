package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import simbad.gap.fit.NearestRange;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/**
 * Readings at whose poses, as well as they are said to be known, nobody can say what the sensor
 * hears: something enters or leaves the cone, or another corner is the nearest.
 *
 * <p>A cone's border is sharp: a model of exact poses takes what a third of a degree decides for an
 * effect.
 */
public final class UncertainPoses {
  /** In standard deviations of the poses: 19 of 20 are nearer. */
  private static final double DEVIATIONS = 2;

  /** If so many are, what is left would be too little of the log to speak for it. */
  private static final double MOST_SHARE = 0.5;

  private final SensingSetup setup;
  private final List<? extends Change> changes;

  private UncertainPoses(SensingSetup setup, List<? extends Change> changes) {
    this.setup = setup;
    this.changes = changes;
  }

  /**
   * Returns such rows.
   *
   * @param setup as the simulator believes it
   * @param rows of the log
   * @param changes of which those of poses, scene and cone count here
   * @return indices of rows; none where poses are exact, or more than half of all rows are such
   */
  public static Set<Integer> rows(
      SensingSetup setup, List<ReadingRow> rows, List<? extends Change> changes) {
    return rows(setup, rows, changes, setup.details().poseSigmaM());
  }

  /**
   * Returns such rows where places are known otherwise than the set-up says.
   *
   * @param setup as the simulator believes it
   * @param rows of the log
   * @param changes of which those of poses, scene and cone count here
   * @param poseSigmaM by what a place is off, standard deviation, metres
   * @return indices of rows; none where poses are exact, or more than half of all rows are such
   */
  public static Set<Integer> rows(
      SensingSetup setup,
      List<ReadingRow> rows,
      List<? extends Change> changes,
      double poseSigmaM) {
    double turn = DEVIATIONS * setup.details().headingSigmaRad();
    double move = DEVIATIONS * poseSigmaM;
    boolean exact = turn == 0 && move == 0;
    if (exact) {
      return Set.of();
    }
    UncertainPoses poses = new UncertainPoses(setup, changes);
    double[] straight = poses.expectedM(rows, 0, 0, 0);
    Set<Integer> unsure = new TreeSet<>();
    for (double way : new double[] {1, -1}) {
      poses.addOthers(unsure, straight, poses.expectedM(rows, way * turn, 0, 0), 0);
      poses.addOthers(unsure, straight, poses.expectedM(rows, 0, way * move, 0), 0);
      // Along the axis a range changes by as much, with the same thing before it.
      poses.addOthers(unsure, straight, poses.expectedM(rows, 0, 0, way * move), move);
    }
    return unsure.size() > MOST_SHARE * rows.size() ? Set.of() : unsure;
  }

  /** By then the pose scatters a range as much as the sensor does, and unlike elsewhere. */
  private void addOthers(Set<Integer> unsure, double[] straight, double[] other, double leaveM) {
    for (int row = 0; row < straight.length; row++) {
      double change = other[row] - straight[row];
      double kept = Math.signum(change) * Math.min(leaveM, Math.abs(change));
      boolean same = straight[row] == other[row];
      if (!same && NearestRange.isAnother(setup.sensor(), straight[row], other[row] - kept)) {
        unsure.add(row);
      }
    }
  }

  /** By row, the nearest obstacle that is likelier heard than not; infinity for none. */
  private double[] expectedM(List<ReadingRow> rows, double turnRad, double leftM, double onM) {
    List<ReadingRow> moved = new ArrayList<>();
    rows.forEach(
        row -> moved.add(row.at(moved(row.pose(), turnRad, leftM, onM), row.circumstances())));
    PingLog log = new PingLog(moved);
    Geometry geometry = new Geometry(log, setup, changes);
    double[] expected = new double[rows.size()];
    for (int ping = 0; ping < log.size(); ping++) {
      expected[log.row(ping)] = expectedM(geometry, ping);
    }
    return expected;
  }

  /** To the left and on, as the sensor looks: z grows down the page. */
  private static Pose moved(Pose pose, double turnRad, double leftM, double onM) {
    double heading = pose.heading().radians();
    double sin = Math.sin(heading);
    double cos = Math.cos(heading);
    return Pose.of(
        pose.position().xM() - sin * leftM + cos * onM,
        pose.position().zM() - cos * leftM - sin * onM,
        heading + turnRad);
  }

  private static double expectedM(Geometry geometry, int ping) {
    double nearest = Double.POSITIVE_INFINITY;
    int first = ping * geometry.obstacles();
    for (int line = first; line < first + geometry.obstacles(); line++) {
      boolean within = geometry.nearestM(line) <= geometry.sensor().maxRangeM();
      if (within && geometry.nearestM(line) < nearest && isHeard(geometry, line)) {
        nearest = geometry.nearestM(line);
      }
    }
    return nearest;
  }

  private static boolean isHeard(Geometry geometry, int line) {
    return geometry.ears() == null
        ? geometry.centreDistanceM(line) <= geometry.thresholdM(line)
        : geometry.excessDb(line) > 0;
  }
}
