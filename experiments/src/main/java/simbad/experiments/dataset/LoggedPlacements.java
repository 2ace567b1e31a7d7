package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.ReadingRow;

/** What follows from several rows of a log: placements, and whether its times order them. */
final class LoggedPlacements {
  /** Readings of a sensor at one place, in the mean, from which on a timed log is of places. */
  private static final int READ_AGAIN = 2;

  private LoggedPlacements() {}

  /** With fewer places a log says nothing of how far each of them is off. */
  private static final int LEAST_PLACES = 4;

  /** What must not have changed. */
  private record Unmoved(String run, Pose pose, MovedObstacle obstacle) {
    static Unmoved of(ReadingRow row) {
      return new Unmoved(row.run(), row.pose(), row.circumstances().obstacle());
    }

    /** The same however sensor and target are turned. */
    Unmoved anyWay() {
      return new Unmoved(
          run,
          Pose.of(pose.position().xM(), pose.position().zM(), 0),
          new MovedObstacle(obstacle.xM(), obstacle.zM(), OptionalDouble.empty()));
    }
  }

  static Circumstances untimed(Circumstances now) {
    return new Circumstances(
        false, now.placement(), now.temperatureC(), now.obstacle(), now.gapS(), now.pauseS());
  }

  /** Rows without their times. */
  static List<ReadingRow> untimed(List<ReadingRow> rows) {
    return rows.stream()
        .map(
            row ->
                new ReadingRow(
                    row.run(),
                    row.sensor(),
                    0,
                    row.pose(),
                    row.reading(),
                    untimed(row.circumstances())))
        .toList();
  }

  /** The first row whose time its run and sensor have had before. */
  static Optional<ReadingRow> findRepeatedTime(List<ReadingRow> rows) {
    record Ping(String run, String sensor, long microseconds) {}
    Set<Ping> seen = new HashSet<>();
    return rows.stream()
        .filter(ReadingRow::isTimed)
        .filter(row -> !seen.add(new Ping(row.run(), row.sensor(), Math.round(row.timeS() * 1e6))))
        .findFirst();
  }

  /** Rows with the names of their placements, and what was taken for granted by that. */
  record Named(List<ReadingRow> rows, Optional<String> assumption) {}

  /**
   * Names what neighbouring rows at one place share; rows that have a name keep theirs. Where a
   * sensor or a target is turned in place, as by a servo or a turntable, it was put there once: all
   * directions share what the place is off by. In a drive that has times each sensor pings once
   * where the robot is, and a robot that turns on the spot moves: nothing was put in place there.
   *
   * @param isServo whether the log says how far the sensor is turned on what carries it
   */
  static Named named(List<ReadingRow> rows, boolean isServo) {
    if (rows.isEmpty() || rows.get(0).circumstances().placement().isPresent()) {
      return new Named(rows, Optional.empty());
    }
    List<Unmoved> poses = rows.stream().map(Unmoved::of).toList();
    if (isServo || !rows.get(0).isTimed()) {
      List<Unmoved> places = poses.stream().map(Unmoved::anyWay).toList();
      boolean isTurned = Set.copyOf(places).size() < Set.copyOf(poses).size();
      if (isTurned && Set.copyOf(places).size() >= LEAST_PLACES) {
        return named(
            rows,
            places,
            "Between neighbouring rows at one place nothing was moved, only turned"
                + " (--placement).");
      }
    }
    return named(
        rows, poses, "Nothing was moved between neighbouring rows with equal poses (--placement).");
  }

  private static Named named(List<ReadingRow> rows, List<Unmoved> unmoved, String assumption) {
    List<ReadingRow> named = new ArrayList<>(rows.size());
    Set<List<Object>> places = new HashSet<>();
    int number = 0;
    for (int i = 0; i < rows.size(); i++) {
      ReadingRow row = rows.get(i);
      number += i > 0 && unmoved.get(i - 1).equals(unmoved.get(i)) ? 0 : 1;
      places.add(List.of(number, row.sensor()));
      Circumstances now = row.circumstances();
      named.add(
          row.at(
              row.pose(),
              new Circumstances(
                  now.isTimed(),
                  Optional.of("p" + number),
                  now.temperatureC(),
                  now.obstacle(),
                  now.gapS(),
                  now.pauseS())));
    }
    boolean again = rows.size() >= READ_AGAIN * places.size();
    return number < rows.size() && (again || !rows.get(0).isTimed())
        ? new Named(named, Optional.of(assumption))
        : new Named(rows, Optional.empty());
  }
}
