package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** What was read of a log, and what looks odd in it. */
final class LogSummary {
  private final List<LogTable> logs;
  private final LogRows taken;
  private final List<ReadingRow> rows;
  private final SensingSetup setup;
  private final LogSettings settings;
  private final DoubleSummaryStatistics ranges;

  LogSummary(
      List<LogTable> logs,
      LogRows taken,
      List<ReadingRow> rows,
      SensingSetup setup,
      LogSettings settings) {
    this.logs = logs;
    this.taken = taken;
    this.rows = rows;
    this.setup = setup;
    this.settings = settings;
    ranges =
        rows.stream()
            .map(ReadingRow::reading)
            .filter(Echo.class::isInstance)
            .mapToDouble(reading -> ((Echo) reading).rangeM())
            .summaryStatistics();
  }

  String line() {
    long places =
        rows.stream()
            .map(row -> List.of(row.pose(), row.circumstances().obstacle()))
            .distinct()
            .count();
    long runs = rows.stream().map(ReadingRow::run).distinct().count();
    int lines = logs.stream().mapToInt(LogTable::size).sum();
    return "read "
        + rows.size()
        + " readings from "
        + lines
        + " rows"
        + (logs.size() > 1 ? " of " + logs.size() + " files" : "")
        + ": "
        + ranges.getCount()
        + " echoes"
        + (ranges.getCount() > 0
            ? " at " + metres(ranges.getMin()) + " to " + metres(ranges.getMax()) + " m"
            : "")
        + ", "
        + (rows.size() - ranges.getCount())
        + " without echo; "
        + places
        + (places == 1 ? " place, " : " places, ")
        + runs
        + (runs == 1 ? " run" : " runs")
        + (rows.get(0).isTimed() ? "" : ", no times");
  }

  private static String metres(double value) {
    return String.format(Locale.ROOT, "%.3f", value);
  }

  List<String> notes() {
    List<String> notes = new ArrayList<>();
    double most = setup.sensor().maxRangeM();
    long beyond = echoes(range -> range > most);
    if (beyond > 0) {
      notes.add(
          Assumptions.counted(beyond, "range")
              + " beyond the sonar's "
              + most
              + " m, the largest "
              + metres(ranges.getMax())
              + " m: is --range-unit "
              + settings.find("range-unit").orElse("")
              + " right, or a number a code (--no-echo)?");
    }
    long zero = echoes(range -> range == 0);
    if (zero > 0) {
      notes.add(Assumptions.counted(zero, "range") + " of 0; if 0 means no echo: --no-echo 0");
    }
    thousands(notes);
    if (!taken.bad().isEmpty()) {
      notes.add(
          Assumptions.counted(taken.bad().size(), "row")
              + " left out that cannot be read, the first: "
              + taken.bad().get(0));
    }
    if (taken.poseless() > 0) {
      notes.add(
          Assumptions.counted(taken.poseless(), "row")
              + " left out: they do not say where sensor or target was");
    }
    return notes;
  }

  private void thousands(List<String> notes) {
    for (LogTable log : logs) {
      for (int column = 0; column < log.names().size(); column++) {
        String name = log.names().get(column);
        log.findThousands(column)
            .ifPresent(
                cell ->
                    notes.add(
                        "'"
                            + cell
                            + "' in column '"
                            + name
                            + "' is read with a decimal point; if the point is between thousands:"
                            + " --decimal comma"));
      }
    }
  }

  private interface Test {
    boolean holds(double rangeM);
  }

  private long echoes(Test test) {
    return rows.stream()
        .filter(row -> row.reading() instanceof Echo echo && test.holds(echo.rangeM()))
        .count();
  }
}
