package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.sensing.ReadingRow;

/** Times that go back or stand twice, and clocks that do not tick as the sensor does. */
final class ClockCheck {
  /** Rows that somebody sorted otherwise go back at every second; a clock does so now and then. */
  private static final double NOW_AND_THEN = 0.02;

  private static final int LEAST_ROWS = 20;

  /** Of a clock that is regular: the middle half of its periods, over their median. */
  private static final double REGULAR = 0.25;

  /** Milliseconds, microseconds. */
  private static final double[] PER_SECOND = {1e3, 1e6};

  private static final double UNIT = 1.5;
  private static final double SAME = 0.25;

  private final AuditView view;
  private final List<AuditFinding> found = new ArrayList<>();

  private ClockCheck(AuditView view) {
    this.view = view;
  }

  static List<AuditFinding> of(AuditView view) {
    ClockCheck check = new ClockCheck(view);
    check.twice();
    check.back();
    check.period();
    return check.found;
  }

  private void twice() {
    List<Integer> same = new ArrayList<>();
    List<Integer> other = new ArrayList<>();
    for (int i = 1; i < view.size(); i++) {
      if (view.follows(i) && view.row(i).timeS() == view.row(i - 1).timeS()) {
        (view.row(i).equals(view.row(i - 1)) ? same : other).add(i);
      }
    }
    if (!same.isEmpty()) {
      add(
          AuditCheck.CLOCK,
          Say.rows(same.size()) + " that stand in the file twice",
          same,
          "leave one of each",
          "--drop-duplicates",
          Severity.WARN);
    }
    if (!other.isEmpty()) {
      add(
          AuditCheck.CLOCK,
          "t_s stands still at " + Say.rows(other.size()) + ", which says not which was first",
          other,
          "write more decimals of t_s, or name another run",
          "",
          Severity.WARN);
    }
  }

  /** In the order of the file, which is no order of time where rows were sorted otherwise. */
  private void back() {
    Map<List<String>, ReadingRow> last = new HashMap<>();
    Map<List<String>, Integer> sizes = new HashMap<>();
    Map<List<String>, List<Integer>> back = new TreeMap<>(ClockCheck::byWords);
    for (int at = 0; at < view.rows().size(); at++) {
      ReadingRow row = view.rows().get(at);
      List<String> sequence = List.of(row.run(), row.sensor());
      ReadingRow before = last.put(sequence, row);
      sizes.merge(sequence, 1, Integer::sum);
      if (before != null && row.timeS() < before.timeS()) {
        back.computeIfAbsent(sequence, name -> new ArrayList<>()).add(at);
      }
    }
    Set<Integer> rows = new HashSet<>();
    back.forEach(
        (sequence, at) -> {
          int size = sizes.getOrDefault(sequence, 0);
          if (size >= LEAST_ROWS && at.size() <= NOW_AND_THEN * size) {
            rows.addAll(at);
          }
        });
    if (!rows.isEmpty()) {
      found.add(
          new AuditFinding(
              AuditCheck.CLOCK,
              File.READINGS,
              "t_s goes back at " + Say.rows(rows.size()) + " of a file in the order of time",
              rows.stream().sorted().toList(),
              "name another run where the clock began anew",
              "",
              Severity.WARN));
    }
  }

  private static int byWords(List<String> one, List<String> other) {
    return String.join("\n", one).compareTo(String.join("\n", other));
  }

  private void period() {
    double[] steps =
        IntStream.range(1, view.size())
            .filter(view::follows)
            .mapToDouble(i -> view.row(i).timeS() - view.row(i - 1).timeS())
            .filter(step -> step > 0)
            .sorted()
            .toArray();
    if (steps.length < LEAST_ROWS) {
      return;
    }
    double median = RobustLine.median(steps);
    double middle = steps[3 * steps.length / 4] - steps[steps.length / 4];
    if (middle > REGULAR * median) {
      return;
    }
    double times = median / view.sensor().updatePeriodS();
    String what =
        "rows of a sensor are "
            + Say.number(median)
            + " s apart before update_period_s = "
            + Say.number(view.sensor().updatePeriodS());
    for (double unit : PER_SECOND) {
      if (times > unit / UNIT && times < unit * UNIT) {
        add(
            AuditCheck.PERIOD,
            what + ": t_s is not in seconds",
            List.of(),
            "divide t_s by " + Say.number(unit),
            "--time-scale " + Say.number(1 / unit),
            Severity.WARN);
        return;
      }
    }
    double nearest = Math.max(1, Math.rint(times));
    if (Math.abs(times - nearest) > SAME) {
      add(
          AuditCheck.PERIOD,
          what,
          List.of(),
          "say in the scene how often it pings",
          "",
          Severity.NOTE);
    }
  }

  private void add(
      AuditCheck check,
      String what,
      List<Integer> rows,
      String suggestion,
      String mend,
      Severity severity) {
    int[] at = rows.stream().mapToInt(Integer::intValue).toArray();
    found.add(
        new AuditFinding(
            check,
            File.READINGS,
            what,
            view.inFile(Arrays.stream(at)),
            suggestion,
            mend,
            severity));
  }
}
