package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/**
 * The audit of a data set before anything is fitted. Deterministic; the order of rows changes
 * nothing but what is said of clocks.
 */
public final class Audit {
  private Audit() {}

  /**
   * Audits a data set without a reference.
   *
   * @param setup as the simulator believes it
   * @param readings in the file's order
   * @return worst first; empty where nothing was found
   */
  public static List<AuditFinding> of(SensingSetup setup, List<ReadingRow> readings) {
    return of(setup, readings, List.of());
  }

  /**
   * Audits a data set.
   *
   * @param setup as the simulator believes it
   * @param readings in the file's order
   * @param reference in the file's order; empty where there is none
   * @return worst first; empty where nothing was found
   */
  public static List<AuditFinding> of(
      SensingSetup setup, List<ReadingRow> readings, List<ReadingRow> reference) {
    List<AuditFinding> found = new ArrayList<>(ConstantCheck.of(setup.sensor()));
    found.addAll(rows(setup, readings));
    rows(setup, reference).stream()
        .map(one -> one.file() == File.READINGS ? one.in(File.REFERENCE) : one)
        .filter(one -> !found.contains(one))
        .forEach(found::add);
    found.sort(Comparator.comparing(AuditFinding::severity).reversed());
    return List.copyOf(found);
  }

  /** Returns whether no reading can be believed, so that nothing shall be fitted. */
  public static boolean refuses(List<AuditFinding> findings) {
    return findings.stream().anyMatch(AuditFinding::refuses);
  }

  private static List<AuditFinding> rows(SensingSetup setup, List<ReadingRow> rows) {
    if (rows.isEmpty()) {
      return List.of();
    }
    AuditView view = new AuditView(setup, rows);
    List<AuditFinding> found = new ArrayList<>(ClockCheck.of(view));
    new PeriodCheck(view).find().ifPresent(found::add);
    found.addAll(PoseCheck.of(view));
    UnitCheck units = new UnitCheck(view);
    Optional<RobustLine> line = units.line();
    // Along one line positions in another unit do the same; ranges are the likelier fault.
    Optional<AuditFinding> axes = line.isPresent() ? Optional.empty() : new AxesCheck(view).find();
    axes.ifPresent(found::add);
    // Before poses are right, nothing of what follows can be told.
    if (axes.filter(AuditFinding::refuses).isEmpty()) {
      found.addAll(ranges(view, units, line));
    }
    return found;
  }

  private static List<AuditFinding> ranges(
      AuditView view, UnitCheck units, Optional<RobustLine> line) {
    List<AuditFinding> found = new ArrayList<>();
    line.ifPresent(one -> found.add(units.finding(one)));
    AuditView mended = line.map(view::along).orElse(view);
    if (!Audit.refuses(found)) {
      new SensorLimitCheck(view).find().ifPresent(found::add);
    }
    // A line that is undone is one of slope 1 in the scene's metres.
    Rest rest = new Rest(mended, line.isPresent() ? RobustLine.IDENTITY : units.fitted());
    List<AuditFinding> repeated = new RepeatCheck(mended, rest).find();
    found.addAll(repeated);
    found.addAll(new PileCheck(mended).find(rowsOf(repeated)));
    if (line.isEmpty()) {
      new WrapCheck(view).find().ifPresent(found::add);
    }
    found.addAll(new HeldCheck(mended).find());
    List<AuditFinding> misplaced = new MisplacedCheck(mended, rest).find();
    Set<Integer> told = new HashSet<>(rowsOf(repeated));
    told.addAll(rowsOf(misplaced));
    new JumpCheck(mended, rest, told).find().ifPresent(found::add);
    found.addAll(misplaced);
    EdgeCheck.of(view).ifPresent(found::add);
    return found;
  }

  private static Set<Integer> rowsOf(List<AuditFinding> findings) {
    return findings.stream()
        .flatMap(finding -> finding.rows().stream())
        .collect(Collectors.toUnmodifiableSet());
  }
}
