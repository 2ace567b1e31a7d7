package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Times of a log that has none, but says how long after the ping or the echo before it each ping
 * was sent. Rows that follow each other are taken for pings that did.
 */
final class PausedTimes {
  private PausedTimes() {}

  /**
   * Adds up the times.
   *
   * @param rows without times
   * @param follows of each row: whether it stands in the log right after the row before
   * @param sonar whose echoes fly
   * @return the rows with times, in runs of pings that followed each other; empty where no row says
   *     when it was sent, or none follows another
   */
  static Optional<List<ReadingRow>> of(
      List<ReadingRow> rows, List<Boolean> follows, SonarSpec sonar) {
    boolean placed = arePlaced(rows);
    List<ReadingRow> timed = new ArrayList<>(rows.size());
    int run = 0;
    boolean any = false;
    for (int i = 0; i < rows.size(); i++) {
      ReadingRow row = rows.get(i);
      OptionalDouble since =
          i > 0 && follows.get(i) && goesOn(rows.get(i - 1), row, placed)
              ? sinceS(rows.get(i - 1), row, sonar)
              : OptionalDouble.empty();
      any |= since.isPresent();
      run += since.isPresent() ? 0 : 1;
      double timeS = since.isPresent() ? timed.get(i - 1).timeS() + since.getAsDouble() : 0;
      timed.add(at(row, row.run() + "-" + run, timeS));
    }
    return any ? Optional.of(timed) : Optional.empty();
  }

  /** Whether most rows have the place of the row before: nothing is moved within milliseconds. */
  private static boolean arePlaced(List<ReadingRow> rows) {
    int same = 0;
    for (int i = 1; i < rows.size(); i++) {
      same += isUnmoved(rows.get(i - 1), rows.get(i)) ? 1 : 0;
    }
    return 2 * same > rows.size();
  }

  private static boolean isUnmoved(ReadingRow before, ReadingRow row) {
    return before.pose().equals(row.pose())
        && before.circumstances().obstacle().equals(row.circumstances().obstacle());
  }

  private static boolean goesOn(ReadingRow before, ReadingRow row, boolean placed) {
    return before.run().equals(row.run())
        && before.sensor().equals(row.sensor())
        && (!placed || isUnmoved(before, row));
  }

  /** From the ping before to this one. */
  private static OptionalDouble sinceS(ReadingRow before, ReadingRow row, SonarSpec sonar) {
    Circumstances now = row.circumstances();
    if (now.gapS().isPresent() || now.pauseS().isEmpty()) {
      return now.gapS();
    }
    // Without an echo it listens as long as one from its greatest range takes.
    double rangeM = before.reading() instanceof Echo echo ? echo.rangeM() : sonar.maxRangeM();
    return OptionalDouble.of(
        now.pauseS().getAsDouble() + 2 * rangeM / sonar.assumedSoundSpeedMPerS());
  }

  private static ReadingRow at(ReadingRow row, String run, double timeS) {
    Circumstances now = row.circumstances();
    return new ReadingRow(
        run,
        row.sensor(),
        timeS,
        row.pose(),
        row.reading(),
        new Circumstances(
            true, now.placement(), now.temperatureC(), now.obstacle(), now.gapS(), now.pauseS()));
  }
}
