package simbad.gap;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.NumbersForNoEcho;
import simbad.gap.audit.Severity;
import simbad.gap.audit.UncertainPoses;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * Rows that an audit found to be no reading of what stands there: stuck, held, or off by a timer's
 * byte, in a log without times, or of a placement where nothing stood as it was written; and rows
 * of which nobody can say what the sensor hears. No effect with a memory can be asked for them, and
 * any other that took them up would be a wrong name. Numbers that only stand for no echo are read
 * as none.
 */
final class LeftOut {
  private static final Set<AuditCheck> NO_READING =
      Set.of(AuditCheck.STUCK, AuditCheck.HELD, AuditCheck.JUMP);

  private final DataSet data;
  private final Set<Integer> wrong = new TreeSet<>();
  private final Set<Integer> rows = new TreeSet<>();
  private final Set<Integer> silent = new TreeSet<>();

  /**
   * Finds them.
   *
   * @param data as it is
   * @param audit of it
   */
  LeftOut(DataSet data, List<AuditFinding> audit) {
    this.data = data;
    audit.stream()
        .filter(finding -> finding.file() == AuditFinding.File.READINGS)
        .forEach(
            finding -> {
              if (finding.severity() == Severity.WARN && NO_READING.contains(finding.check())) {
                finding.rows().stream()
                    .filter(row -> !data.readings().get(row).isTimed())
                    .forEach(wrong::add);
              } else if (finding.check() == AuditCheck.MISPLACED) {
                wrong.addAll(finding.rows());
              } else if (finding.check() == AuditCheck.EDGE) {
                rows.addAll(finding.rows());
              }
            });
    rows.addAll(wrong);
    silent.addAll(NumbersForNoEcho.rows(data.setup(), data.readings(), audit));
  }

  private LeftOut(LeftOut known, Set<Integer> more) {
    data = known.data;
    wrong.addAll(known.wrong);
    rows.addAll(known.rows);
    rows.addAll(more);
    silent.addAll(known.silent);
  }

  /**
   * Returns the same with rows of which nobody can say what the sensor hears if effects are at
   * work; itself where all of them are left out already.
   *
   * @param effects that were found
   */
  LeftOut under(Hypothesis effects) {
    Set<Integer> unsure = UncertainPoses.rows(data.setup(), data.readings(), effects.changes());
    return rows.containsAll(unsure) ? this : new LeftOut(this, unsure);
  }

  /** Returns the data set without them, and with no echo where a number stood for it. */
  DataSet rest() {
    if (rows.isEmpty() && silent.isEmpty()) {
      return data;
    }
    List<ReadingRow> kept = new ArrayList<>();
    for (int row = 0; row < data.readings().size(); row++) {
      if (!rows.contains(row)) {
        ReadingRow read = data.readings().get(row);
        kept.add(silent.contains(row) ? read.reading(NoEcho.NO_ECHO) : read);
      }
    }
    return new DataSet(data.name(), data.setup(), kept, data.reference());
  }

  /** Returns what is said of the whole, from a diagnosis of the rest: with such rows never none. */
  Diagnosis whole(Diagnosis rest) {
    if (rest.verdict() != Verdict.NONE || (wrong.isEmpty() && silent.isEmpty())) {
      return rest;
    }
    String of = " of " + data.readings().size() + " readings";
    return rest.undecided(
        wrong.isEmpty()
            ? silent.size()
                + of
                + " are a number that stands for no echo; taken as that, no effect"
                + " shows"
            : "what the audit found is wrong with "
                + wrong.size()
                + of
                + "; the others show no effect");
  }
}
