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
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Placements;
import simbad.gap.score.PlacementScatter;
import simbad.sonar.ping.PingLog;
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

  /** To three standard deviations instead of two. */
  private static final double WIDER = 1.5;

  private final DataSet data;
  private final Set<Integer> wrong = new TreeSet<>();
  private final Set<Integer> rows = new TreeSet<>();
  private final Set<Integer> silent = new TreeSet<>();
  private final Set<Integer> silentBefore = new TreeSet<>();

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
    silent.addAll(
        NumbersForNoEcho.rows(data.setup(), data.readings(), audit, AuditFinding.File.READINGS));
    silentBefore.addAll(
        NumbersForNoEcho.rows(data.setup(), data.reference(), audit, AuditFinding.File.REFERENCE));
  }

  private LeftOut(LeftOut known, Set<Integer> more) {
    data = known.data;
    wrong.addAll(known.wrong);
    rows.addAll(known.rows);
    rows.addAll(more);
    silent.addAll(known.silent);
    silentBefore.addAll(known.silentBefore);
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

  /**
   * Returns the same with rows of which nobody can say what the sensor hears where each placement
   * is as far off as readings of one hang together; itself where nothing was put in place, or is as
   * exact as believed.
   */
  LeftOut misplaced() {
    PingLog log = new PingLog(data.readings());
    CalibratedLog given = new CalibratedLog(data.setup(), List.of(), log);
    double offM = PlacementScatter.betweenM(given, new Placements(log));
    if (offM <= data.setup().details().poseSigmaM()) {
      return this;
    }
    // All readings of a placement are off at once: one in 20 of those would be many.
    Set<Integer> unsure = unsure(WIDER * offM);
    Set<Integer> misplaced = unsure.isEmpty() ? unsure(offM) : unsure;
    return rows.containsAll(misplaced) ? this : new LeftOut(this, misplaced);
  }

  private Set<Integer> unsure(double offM) {
    return UncertainPoses.rows(data.setup(), data.readings(), List.of(), offM);
  }

  /** Returns what an audit found, and by that how many rows more than by another are left out. */
  List<AuditFinding> told(List<AuditFinding> audit, LeftOut other) {
    List<Integer> more = rows.stream().filter(row -> !other.rows.contains(row)).toList();
    List<AuditFinding> told = new ArrayList<>(audit);
    told.add(
        new AuditFinding(
            AuditCheck.EDGE,
            AuditFinding.File.READINGS,
            more.size()
                + " readings where a placement that is as far off as these are decides what is"
                + " heard",
            more,
            "these rows are left out of all that follows",
            "",
            Severity.NOTE));
    return told;
  }

  /** Returns the data set without them, and with no echo where a number stood for it. */
  DataSet rest() {
    if (rows.isEmpty() && silent.isEmpty() && silentBefore.isEmpty()) {
      return data;
    }
    List<ReadingRow> kept = new ArrayList<>();
    List<ReadingRow> read = heard(data.readings(), silent);
    for (int row = 0; row < read.size(); row++) {
      if (!rows.contains(row)) {
        kept.add(read.get(row));
      }
    }
    return new DataSet(data.name(), data.setup(), kept, heard(data.reference(), silentBefore));
  }

  private static List<ReadingRow> heard(List<ReadingRow> read, Set<Integer> numbers) {
    List<ReadingRow> heard = new ArrayList<>(read);
    numbers.forEach(row -> heard.set(row, read.get(row).reading(NoEcho.NO_ECHO)));
    return heard;
  }

  /**
   * Returns what is said of the whole, from a diagnosis of the rest: with such rows never none. A
   * number for no echo that the reference has, too, belongs to the set-up.
   */
  Diagnosis whole(Diagnosis rest) {
    boolean isNew = !silent.isEmpty() && silentBefore.isEmpty();
    if (rest.verdict() != Verdict.NONE || (wrong.isEmpty() && !isNew)) {
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
