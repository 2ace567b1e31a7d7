package simbad.gap.audit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.sensing.ReadingRow;

/** Times that go back or stand twice. */
final class ClockCheck {
  /** Rows that somebody sorted otherwise go back at every second; a clock does so now and then. */
  private static final double NOW_AND_THEN = 0.02;

  private static final int LEAST_ROWS = 20;

  private final AuditView view;
  private final List<AuditFinding> found = new ArrayList<>();

  private ClockCheck(AuditView view) {
    this.view = view;
  }

  static List<AuditFinding> of(AuditView view) {
    ClockCheck check = new ClockCheck(view);
    check.twice();
    check.back();
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
          Say.rows(same.size()) + " that are in the file twice",
          same,
          "keep one of each",
          "--drop-duplicates");
    }
    if (!other.isEmpty()) {
      add(
          "t_s stays at " + Say.rows(other.size()) + ", so the order of these rows is unknown",
          other,
          "write more decimals of t_s, or give the rows another run name",
          "");
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
          if (size >= LEAST_ROWS && at.size() <= Math.max(1, NOW_AND_THEN * size)) {
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
              "give the rows another run name where the clock started again",
              "",
              Severity.WARN));
    }
  }

  private static int byWords(List<String> one, List<String> other) {
    return String.join("\n", one).compareTo(String.join("\n", other));
  }

  private void add(String what, List<Integer> rows, String suggestion, String mend) {
    found.add(
        new AuditFinding(
            AuditCheck.CLOCK,
            File.READINGS,
            what,
            view.inFile(rows.stream().mapToInt(Integer::intValue)),
            suggestion,
            mend,
            Severity.WARN));
  }
}
