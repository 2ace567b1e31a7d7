package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
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

  /** What must not have changed. */
  private record Unmoved(String run, Pose pose, MovedObstacle obstacle) {
    static Unmoved of(ReadingRow row) {
      return new Unmoved(row.run(), row.pose(), row.circumstances().obstacle());
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

  /**
   * Names what neighbouring rows of equal poses share; rows that have a name keep theirs. In a
   * drive that has times each sensor pings once where the robot is: nothing was put in place there.
   */
  static List<ReadingRow> named(List<ReadingRow> rows) {
    if (rows.isEmpty() || rows.get(0).circumstances().placement().isPresent()) {
      return rows;
    }
    List<ReadingRow> named = new ArrayList<>(rows.size());
    Set<List<Object>> places = new HashSet<>();
    int number = 0;
    for (int i = 0; i < rows.size(); i++) {
      ReadingRow row = rows.get(i);
      number += i > 0 && Unmoved.of(rows.get(i - 1)).equals(Unmoved.of(row)) ? 0 : 1;
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
    return number < rows.size() && (again || !rows.get(0).isTimed()) ? named : rows;
  }
}
