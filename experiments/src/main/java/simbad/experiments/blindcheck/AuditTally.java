package simbad.experiments.blindcheck;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.PostedFault;
import simbad.gap.audit.Severity;
import simbad.gap.diagnosis.DataSet;

/**
 * How often the audit warns of data in which nothing is wrong, and how often it finds what was put
 * into them. A warning that names what is at work is none of the former.
 */
public final class AuditTally {
  private static final long SEED = 1;

  /** What a check's warning is right about. */
  private static final Map<AuditCheck, Set<String>> NAMES =
      Map.of(
          AuditCheck.UNIT, Set.of("sound-speed"),
          AuditCheck.HELD, Set.of("stale-reading", "sticky-reading"),
          AuditCheck.STUCK, Set.of("stale-reading", "sticky-reading"),
          AuditCheck.NO_ECHO_CODE, Set.of("no-echo-code"),
          AuditCheck.WRAP, Set.of("wrap"),
          AuditCheck.AXES, Set.of());

  private final List<String> lines = new ArrayList<>();
  private final Map<String, Share> shares = new LinkedHashMap<>();

  /** So many of so many. */
  private static final class Share {
    private int hits;
    private int all;

    private void count(boolean hit) {
      hits += hit ? 1 : 0;
      all++;
    }
  }

  /** Creates one without cases. */
  public AuditTally() {}

  /**
   * Audits a case as it is and, where nothing is at work in it, with every fault.
   *
   * @param data of the case
   * @param truth names of what is at work in it
   */
  public void add(DataSet data, Set<String> truth) {
    List<AuditFinding> found = Audit.of(data.setup(), data.readings(), data.reference());
    String group = truth.isEmpty() ? "clean" : "with effects";
    group += data.reference().isEmpty() ? ", without a reference" : ", with a reference";
    Predicate<AuditFinding> isFalse =
        one ->
            warns(one)
                && NAMES.getOrDefault(one.check(), Set.of()).stream().noneMatch(truth::contains);
    share("warned of falsely: " + group).count(found.stream().anyMatch(isFalse));
    share("refused: " + group).count(Audit.refuses(found));
    if (truth.contains("stale-reading")) {
      share("found: stale-reading, as blind-world draws it")
          .count(found.stream().anyMatch(one -> one.check() == AuditCheck.HELD));
    }
    lines.add(
        data.name()
            + ","
            + String.join("+", new TreeSet<>(truth))
            + ","
            + words(found, one -> true)
            + ","
            + words(found, isFalse));
    if (truth.isEmpty()) {
      PostedFault.all().forEach(fault -> add(data, fault));
    }
  }

  private void add(DataSet data, PostedFault fault) {
    var rows =
        fault.spoil().spoil(data.readings(), data.setup().sensor(), new SplittableRandom(SEED));
    boolean hit =
        Audit.of(data.setup(), rows).stream()
            .anyMatch(one -> warns(one) && one.check() == fault.check());
    share("found: " + fault.name()).count(hit);
  }

  private Share share(String name) {
    return shares.computeIfAbsent(name, key -> new Share());
  }

  private static boolean warns(AuditFinding finding) {
    return finding.severity() != Severity.NOTE;
  }

  private static String words(List<AuditFinding> findings, Predicate<AuditFinding> which) {
    return findings.stream()
        .filter(which)
        .map(one -> one.severity().word() + " " + one.check().word())
        .distinct()
        .collect(Collectors.joining("+"));
  }

  /** Returns the cases as csv: name, effects, findings, those that are false. */
  public String csv() {
    return "case,effects,findings,false\n" + String.join("\n", lines) + "\n";
  }

  /** Returns the shares with Wilson's 95 % intervals (1927), one a line. */
  public List<String> table() {
    return shares.entrySet().stream().map(one -> line(one.getKey(), one.getValue())).toList();
  }

  private static String line(String name, Share share) {
    CheckScores.Estimate counted = new WilsonShare(share.hits, share.all).estimate();
    return String.format(
        Locale.ROOT,
        "%-55s %4d of %4d (%.1f to %.1f %%)",
        name,
        share.hits,
        share.all,
        100 * counted.low(),
        100 * counted.high());
  }
}
